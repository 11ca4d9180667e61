# What a killed window left of a live session is listed and deleted; another window's is not touched.
export XDG_CACHE_HOME=$PWD/cache
rocinante view --leftovers
mkdir -p cache/rocinante/live/session-killed cache/rocinante/live/session-alive
printf '%2000s' '' >cache/rocinante/live/session-killed/live-000001.mcap
printf '%1000s' '' >cache/rocinante/live/session-killed/live-000002.mcap
printf '%1000s' '' >cache/rocinante/live/session-alive/live-000001.mcap
{
  flock 9
  rocinante view --leftovers | sed "s|$PWD|HERE|"
  rocinante view --forget-leftovers | sed "s|$PWD|HERE|"
} 9>cache/rocinante/live/session-alive/window.lock
ls cache/rocinante/live
