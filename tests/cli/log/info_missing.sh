rocinante log info nowhere.mcap
