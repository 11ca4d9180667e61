# Every verb that --help lists answers --help and --version, and refuses a flag it does not know.
for verb in $(rocinante --help | awk '/^  [a-z]/{print $1}'); do
  # A build without a window has no viewer.
  [ -x "$(dirname "$(command -v rocinante)")/rocinante-$verb" ] || [ "$verb" = view ] || { echo "$verb: missing"; continue; }
  [ -x "$(dirname "$(command -v rocinante)")/rocinante-$verb" ] || continue
  rocinante "$verb" --help >help
  grep -q '^Examples:' help || echo "$verb: no examples in --help"
  version=$(rocinante "$verb" --version)
  [ "$version" = "rocinante 0.1.0" ] || echo "$verb: --version says something else"
  status=0
  rocinante "$verb" --no-such-flag >/dev/null 2>complaint || status=$?
  [ "$status" = 2 ] || echo "$verb: exit $status for an unknown flag"
  [ "$(wc -l <complaint)" = 1 ] || echo "$verb: not one line for an unknown flag"
done
