# The usage line shows required arguments; the examples are those of the subcommand.
rocinante log split --help
