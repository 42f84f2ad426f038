# Writes OUT, which defines waymark::tools::help_topics(): the pages FILES (separated by commas) as raw strings.
string(REPLACE "," ";" files "${FILES}")
set(rows "")
set(count 0)
foreach(file IN LISTS files)
  get_filename_component(name ${file} NAME_WE)
  file(READ ${file} text)
  string(APPEND rows "    HelpTopic{\"${name}\", R\"embedded(${text})embedded\"},\n")
  math(EXPR count "${count} + 1")
endforeach()
file(WRITE ${OUT} "#include \"tools/help/topics.hpp\"

#include <array>

namespace waymark::tools {

std::span<const HelpTopic> help_topics() {
  static constexpr std::array<HelpTopic, ${count}> all{
${rows}  };
  return all;
}

}  // namespace waymark::tools
")
