# cmake -DHEADER=a/b.h -DFILES=kName:file,kOther:file -DOUTPUT=FILE.cpp -P embed_text.cmake
# Writes the contents of files as the constants that the header declares.
set(text "#include \"${HEADER}\"\n\nnamespace rocinante {\n\n")
string(REPLACE "," ";" pairs "${FILES}")
foreach(pair ${pairs})
  string(REGEX REPLACE ":.*" "" name "${pair}")
  string(REGEX REPLACE "^[^:]*:" "" file "${pair}")
  file(READ "${file}" content)
  string(APPEND text "const std::string_view ${name} = R\"embedded(${content})embedded\";\n\n")
endforeach()
file(WRITE ${OUTPUT} "${text}}  // namespace rocinante\n")
