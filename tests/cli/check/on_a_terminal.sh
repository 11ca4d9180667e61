# The verdict stands above the report and below it; a line that is too long goes on behind its begin.
cp -r "$SRC/examples/demo" demo
sed -i 's/limit lower="-2.96" upper="2.96"/limit lower="-0.3" upper="0.3"/' demo/arm.urdf
on_terminal 60 rocinante check demo/demo.cell.toml demo/session.mcap || echo "exit $?"
echo "== nothing is wrong"
on_terminal 60 rocinante check "$SRC/examples/demo/demo.cell.toml" | sed "s#$SRC/##g"
