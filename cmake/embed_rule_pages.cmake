# cmake -DPAGES=FOLDER -DOUTPUT=FILE.cpp -P embed_rule_pages.cmake
# Writes what the pages of docs/rules say of each rule as a table that the check library holds.
file(GLOB pages "${PAGES}/*.md")
list(SORT pages)
set(end ")page\"},\n")
string(LENGTH "${end}" end_length)
set(text "#include <iterator>\n\n#include \"core/check/rules/rule_page.h\"\n\n")
string(APPEND text "namespace rocinante::detail {\n\nconst RulePage kRulePages[] = {\n")
foreach(page ${pages})
  file(READ ${page} content)
  # Behind the head of the page, every heading of two marks begins a rule.
  string(FIND "${content}" "\n## " first)
  if(page MATCHES "/README\\.md$" OR first LESS 0)
    continue()
  endif()
  string(SUBSTRING "${content}" ${first} -1 content)
  string(REGEX REPLACE "\n## ([a-z.-]+)\n" "${end}    {\"\\1\", R\"page(# \\1\n" content "${content}")
  string(SUBSTRING "${content}" ${end_length} -1 content)  # the first ends none
  string(APPEND text "${content}${end}")
endforeach()
string(APPEND text "};\nconst std::size_t kRulePageCount = std::size(kRulePages);\n\n")
string(APPEND text "}  // namespace rocinante::detail\n")
file(WRITE ${OUTPUT} "${text}")
