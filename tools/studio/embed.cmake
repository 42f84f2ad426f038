# Writes OUT, which defines waymark::studio::assets(): the files of FOLDER as raw strings, index.html as "/". The style
# stands in the page, which is then painted without a second request.
file(GLOB files RELATIVE ${FOLDER} ${FOLDER}/*)
list(REMOVE_ITEM files studio.css)
list(SORT files)
set(type_html "text/html; charset=utf-8")
set(type_css "text/css; charset=utf-8")
set(type_js "text/javascript; charset=utf-8")
set(type_svg "image/svg+xml")
set(rows "")
set(count 0)
foreach(name IN LISTS files)
  file(READ ${FOLDER}/${name} text)
  string(REGEX REPLACE ".*\\." "" kind ${name})
  set(path /${name})
  if(name STREQUAL index.html)
    set(path /)
    file(READ ${FOLDER}/studio.css style)
    string(REPLACE "<link rel=\"stylesheet\" href=\"/studio.css\">" "<style>\n${style}</style>" text "${text}")
  endif()
  string(APPEND rows "    Asset{\"${path}\", \"${type_${kind}}\", R\"embedded(${text})embedded\"},\n")
  math(EXPR count "${count} + 1")
endforeach()
file(WRITE ${OUT} "#include \"tools/studio/assets.hpp\"

#include <array>

namespace waymark::studio {

std::span<const Asset> assets() {
  static constexpr std::array<Asset, ${count}> all{
${rows}  };
  return all;
}

}  // namespace waymark::studio
")
