# What zsh offers for the word that is being typed; one whole run of it in a terminal of its own.
command -v zsh >/dev/null || { echo "skipped: there is no zsh here"; exit 77; }
offer() {
  echo "$*: $(zsh -f -c 'source $SRC/completions/_rocinante; _rocinante_offers "$@"' zsh "$@" | grep "^${*: -1}" | sort | sed -n 1,4p | tr '\n' ';')"
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
cat >whole.zsh <<'ZSH'
zmodload zsh/zpty
zpty shell 'TERM=dumb zsh -f'
zpty -w shell "fpath=($SRC/completions \$fpath); autoload -Uz compinit; compinit -D -u; echo the''re"
zpty -r shell said '*there*'
# What was completed is run, and says what it was.
zpty -w shell $'rocinante log rec\t--help'
zpty -r shell said '*Usage: *OUT*' && print 'in a terminal:' ${(M)${(f)said}:#Usage*}
ZSH
zsh -f whole.zsh | tr -d '\r'
