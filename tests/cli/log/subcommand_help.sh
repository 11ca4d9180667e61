# What must be given stands in the usage line; examples are those of the subcommand.
rocinante log split --help
