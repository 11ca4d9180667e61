# The descriptors of the examples are those of their .proto files.
command -v protoc >/dev/null || { echo "skipped: no protoc"; exit 77; }
for proto in "$SRC"/examples/decoders/*.proto; do
  name=$(basename "$proto" .proto)
  protoc --include_imports -I "$SRC/examples/decoders" -o "$name.binpb" "$proto"
  # Descriptors of all versions of protoc say the same, not with the same bytes.
  for file in "$name.binpb" "$SRC/examples/decoders/$name.binpb"; do
    protoc --decode_raw <"$file" | sha256sum
  done | uniq | wc -l
done
