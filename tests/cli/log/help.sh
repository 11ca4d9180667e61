# The first lines of help, and a subcommand's.
. "$SRC/tests/support/blocks.sh"

block "help"
rocinante log --help | sed -n '1,2p'

# The usage line shows required arguments; the examples are those of the subcommand.
block "subcommand help"
rocinante log split --help
