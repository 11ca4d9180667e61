# Sourced by cases of several blocks: `block WORDS` begins one, in an empty folder of its own, and prints its words to
# both outputs. A command that may fail has `|| echo "exit $?"`.
here=$PWD
block() {
  cd "$(mktemp -d -p "$here")"
  echo "== $1"
  echo "== $1" >&2
}
