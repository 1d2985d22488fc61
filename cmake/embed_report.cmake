# SPDX-License-Identifier: BSD-3-Clause
# Writes a source file that holds the report's page (src/report/page/*), so that programs need no installed files
# to write it and the page is edited as HTML, CSS and JavaScript.
file(GLOB page_files CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/page/*)
list(SORT page_files)
set(entries "")
foreach(file IN LISTS page_files)
  get_filename_component(name ${file} NAME)
  file(READ ${file} text)
  string(APPEND entries "      {\"${name}\", R\"page(${text})page\"},\n")
  set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
endforeach()
file(GENERATE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/page_files.cpp CONTENT
"// Made from src/report/page/ by cmake/embed_report.cmake.
#include \"segdf/report/page_files.hpp\"

namespace segdf {

const std::map<std::string, std::string>& pageFiles() {
  static const std::map<std::string, std::string> kFiles{
${entries}  };
  return kFiles;
}

}  // namespace segdf
")
