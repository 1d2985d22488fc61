# SPDX-License-Identifier: BSD-3-Clause
# segdf_embed_yaml(FOLDER HEADER FUNCTION OUTPUT): writes a source file, its path in OUTPUT, that holds
# cfg/FOLDER/*.yaml behind the FUNCTION that HEADER declares, so that programs need no installed files to know
# them and the YAML files stay the only place where they are written down.
function(segdf_embed_yaml folder header function output)
  file(GLOB files CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/cfg/${folder}/*.yaml)
  list(SORT files)
  set(entries "")
  foreach(file IN LISTS files)
    get_filename_component(name ${file} NAME_WE)
    file(READ ${file} text)
    string(APPEND entries "      {\"${name}\", R\"yaml(${text})yaml\"},\n")
    set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  endforeach()
  set(source ${CMAKE_CURRENT_BINARY_DIR}/${folder}_files.cpp)
  file(GENERATE OUTPUT ${source} CONTENT
"// Made from cfg/${folder} by cmake/embed_yaml.cmake.
#include \"${header}\"

namespace segdf {

const std::map<std::string, std::string>& ${function}() {
  static const std::map<std::string, std::string> kFiles{
${entries}  };
  return kFiles;
}

}  // namespace segdf
")
  set(${output} ${source} PARENT_SCOPE)
endfunction()
