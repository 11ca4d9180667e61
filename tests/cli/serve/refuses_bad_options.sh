# What cannot be served is said in one sentence, before anything is loaded where that can be known.
demo=$SRC/examples/demo
serve() { rocinante serve "$@" 2>&1 | sed "s|$SRC|SRC|g" || echo "exit $?"; }
serve
serve "$demo/demo.cell.toml"
serve "$demo/demo.cell.toml" "$demo/session.mcap" --live
serve "$demo/demo.cell.toml" "$demo/session.mcap" --trust keys
serve "$demo/demo.cell.toml" --live --listen 8080
serve "$demo/demo.cell.toml" --live --listen 239.1.2.3:80
serve "$demo/demo.cell.toml" --live --listen udp://127.0.0.1:80
serve "$demo/demo.cell.toml" --live --tls-cert cert.pem
serve "$demo/demo.cell.toml" --live --token short
serve "$demo/demo.cell.toml" --live --token 'a token with spaces'
serve "$demo/demo.cell.toml" --live --token-file nowhere
serve "$demo/demo.cell.toml" --live --allow 10.0.0.1/8
serve "$demo/demo.cell.toml" --live --buffer 1kB
serve "$demo/demo.cell.toml" --live --clients 0
serve "$demo/demo.cell.toml" --live --rate 0
serve "$demo/demo.cell.toml" --live --viewer nowhere
serve nowhere.toml "$demo/session.mcap"
mkdir viewer && echo x >viewer/rocinante-viewer.js && echo y >viewer/rocinante-viewer.wasm
serve "$demo/demo.cell.toml" nowhere.mcap --viewer viewer
truncate -s 5G long.mcap
serve "$demo/demo.cell.toml" long.mcap --viewer viewer
serve "$demo/demo.cell.toml" "$demo/demo.cell.toml" --viewer viewer
serve "$demo/demo.cell.toml" "$demo/session.mcap" --viewer viewer --listen 127.0.0.1:0 --origin nonsense
serve "$demo/demo.cell.toml" "$demo/session.mcap" --viewer viewer --listen 127.0.0.1:0 --tls-cert no.pem --tls-key no.pem
