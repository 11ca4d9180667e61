rocinante source --help
