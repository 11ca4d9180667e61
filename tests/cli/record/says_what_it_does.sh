rocinante record --help
