# What fish offers for the word that is being typed.
command -v fish >/dev/null || { echo "skipped: there is no fish here"; exit 77; }
export HOME=$PWD XDG_CONFIG_HOME=$PWD XDG_DATA_HOME=$PWD
offer() {
  echo "$1: $(fish --no-config -c 'source $SRC/completions/rocinante.fish; complete -C $argv[1]' "$1" | sort | sed -n 1,4p | tr '\t\n' ':;')"
}
offer 'rocinante re'
offer 'rocinante log s'
offer 'rocinante log cut --from-'
offer 'rocinante play --spe'
offer 'rocinante check --fail-on '
offer 'rocinante check --format j'
offer 'rocinante-log d'
touch cell.toml
offer 'rocinante check ce'
offer 'rocinante dance --'
