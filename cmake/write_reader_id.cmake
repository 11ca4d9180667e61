# cmake -DARCHIVES=a.a,b.a -DOUTPUT=FILE.cpp -P write_reader_id.cmake
# Writes viewer/bake/reader_id.h's function: the hash of these libraries' contents.
string(REPLACE "," ";" archives "${ARCHIVES}")
set(hashes "")
foreach(archive ${archives})
  file(SHA256 "${archive}" hash)
  string(APPEND hashes "${hash} ")
endforeach()
string(SHA256 id "${hashes}")
file(WRITE "${OUTPUT}" "#include \"viewer/bake/reader_id.h\"\n\nnamespace rocinante {\n\n"
  "std::string_view cellReaderId() { return \"${id}\"; }\n\n}  // namespace rocinante\n")
