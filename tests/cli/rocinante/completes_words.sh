# What a shell offers for the word that is being typed.
. "$SRC/completions/rocinante"
offer() {
  COMP_WORDS=("$@")
  COMP_CWORD=$(($# - 1))
  _rocinante
  echo "$*: ${COMPREPLY[*]}"
}
offer rocinante re
offer rocinante log s
offer rocinante log cut --from-
offer rocinante play --spe
offer rocinante check --fail-on ""
offer rocinante check --format j
offer rocinante-log d
offer rocinante check ce
offer rocinante dance --
