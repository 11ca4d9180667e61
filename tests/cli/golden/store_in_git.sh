# A store that is a ref of the same repository: approved pictures and accepted logs are pushed to it, fetched where they
# are needed, also by shallow clones, and collected when no branch names them. The work tree has none of them.
command -v git >/dev/null || { echo "skipped: no git"; exit 77; }
export ROCINANTE_USER=ada HOME=$PWD GIT_CONFIG_NOSYSTEM=1 GIT_AUTHOR_NAME=a GIT_AUTHOR_EMAIL=a@b GIT_COMMITTER_NAME=a GIT_COMMITTER_EMAIL=a@b
git config --global init.defaultBranch main
git config --global advice.detachedHead false
remote=file://$PWD/remote.git
git init --quiet --bare remote.git
git -C remote.git config uploadpack.allowFilter true
git -C remote.git config uploadpack.allowAnySHA1InWant true
git clone --quiet "$remote" ada 2>/dev/null
top=$PWD
names() { git -C "$top/remote.git" ls-tree --name-only "$1" | wc -l; }
box() { echo "<robot name=\"box\"><link name=\"body\"><visual><geometry><box size=\"1 1 $1\"/></geometry></visual></link></robot>" >box.urdf; }
cd ada
box 1
cat >suite.toml <<'TOML'
format = 1
cell = "box.urdf"
store = "git:refs/goldens"
[defaults]
size = [64, 48]
samples = 1
[[case]]
name = "a"
[[case]]
name = "b"
hide = ["layer/grid"]
mask = ["box/body"]
TOML
rocinante golden approve suite.toml -m first
git add . && git commit --quiet -m first && git push --quiet origin HEAD
echo "in the work tree: $(git ls-files | tr '\n' ' ')"
echo "before the push, elsewhere:"
git clone --quiet --depth 1 "$remote" ../early
(cd ../early && rocinante golden list suite.toml --verify 2>&1 | sed 's/[^ ]*rocinante.[^ ]*png/FILE/' | tail -3) || echo "exit $?"
rocinante golden push suite.toml
rocinante golden push suite.toml
echo "the ref has $(names refs/goldens/files) files"

echo "a shallow clone:"
git clone --quiet --depth 1 "$remote" ../shallow
cd ../shallow
files=.git/rocinante/refs_goldens_files/files
rocinante golden run suite.toml --only a --only b | tail -1
echo "fetched: $(ls $files 2>/dev/null | wc -l)"
# Changed: only what is looked at is fetched.
box 2
rocinante golden run suite.toml --only a >/dev/null || echo "exit $?"
echo "fetched: $(ls $files 2>/dev/null | wc -l)"
git checkout --quiet box.urdf
rocinante golden list suite.toml --verify | tail -1
echo "fetched: $(ls $files 2>/dev/null | wc -l)"
git status --short
git config --get-regexp 'promisor|partialclone' || true

echo "two that push at once:"
for who in bob eve; do git clone --quiet "$remote" ../$who; done
for who in bob eve; do
  (cd ../$who && git checkout --quiet -b $who && { [ $who = bob ] && box 3 || box 4; } &&
    rocinante golden approve suite.toml -m $who >/dev/null && git commit --quiet -am $who && git push --quiet origin $who)
done
for who in bob eve; do (cd ../$who && rocinante golden push suite.toml >pushed.txt 2>&1 || echo "exit $?" >>pushed.txt) & done
wait
cat ../bob/pushed.txt ../eve/pushed.txt | sed 's/, [0-9] there already//; s/ (attempt [0-9]*)//'
echo "the ref has $(names refs/goldens/files) files"

echo "collected:"
cd ../ada
rocinante golden gc suite.toml
rocinante golden gc suite.toml --keep-days 0
git push --quiet origin :eve
rocinante golden gc suite.toml
rocinante golden gc suite.toml --keep-days 0 --dry-run | sed 's/[0-9a-f]\{32\}/HASH/'
rocinante golden gc suite.toml --keep-days 0 | sed 's/[0-9a-f]\{32\}/HASH/'
echo "the ref has $(names refs/goldens/files) files"
git -C ../remote.git rev-list --count refs/goldens/files
(cd ../bob && rm -r .git/rocinante && rocinante golden run suite.toml --only a --only b | tail -1)
# What is here can be pushed again.
(cd ../eve && rocinante golden push suite.toml)

echo "a submodule:"
git init --quiet ../super
(cd ../super && git -c protocol.file.allow=always submodule --quiet add "$remote" parts 2>/dev/null && cd parts &&
  rocinante golden list suite.toml --verify | tail -1 && ls ../.git/modules/parts/rocinante && git status --short)

echo "a remote without filters:"
git -C ../remote.git config uploadpack.allowFilter false
git -C ../remote.git config uploadpack.allowAnySHA1InWant false
git clone --quiet --depth 1 "$remote" ../old
(cd ../old && rocinante golden list suite.toml --verify | tail -1)

echo "a ref of somebody else:"
git notes add -m reviewed && git push --quiet origin refs/notes/commits
notes=$(git -C ../remote.git rev-parse refs/notes/commits)
sed 's/refs.goldens/refs\/notes\/commits/' suite.toml >notes.toml
for verb in push gc; do
  rocinante golden $verb notes.toml 2>&1 | sed 's/commit [0-9a-f]*;/commit HASH;/; s/ (.*//' || echo "exit $?"
done
[ "$notes" = "$(git -C ../remote.git rev-parse refs/notes/commits)" ] && echo "it is as it was"

echo "a ref from before the mark:"
tree=$(git -C ../remote.git rev-parse 'refs/goldens/files^{tree}')
unmarked=$(git -C ../remote.git commit-tree "$tree" -m "golden push: 3")
git -C ../remote.git update-ref refs/goldens/files "$unmarked"
rocinante golden push suite.toml
rocinante golden gc suite.toml --keep-days 0 --dry-run | sed 's/[0-9a-f]\{32\}/HASH/'

echo "refusals:"
sed 's/refs.goldens/refs\/heads\/goldens/' suite.toml >branch.toml
rocinante golden run branch.toml || echo "exit $?"
sed 's/git:refs.goldens/git:goldens/' suite.toml >plain.toml
rocinante golden run plain.toml || echo "exit $?"
sed 's/^store.*//' suite.toml >none.toml
rocinante golden push none.toml || echo "exit $?"
mkdir ../outside && cp box.urdf suite.toml ../outside
(cd ../outside && GIT_CEILING_DIRECTORIES=$(dirname "$PWD") rocinante golden run suite.toml 2>&1 | sed 's/ (.*//') || echo "exit $?"
git remote remove origin
rocinante golden push suite.toml 2>&1 | sed 's/ (.*//' || echo "exit $?"
