# SPDX-License-Identifier: BSD-3-Clause
# Writes a source file that holds cfg/sensors/*.yaml, so that programs need no installed files to know their
# sensors and the YAML files stay the only place where these are written down.
file(GLOB sensor_files CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/cfg/sensors/*.yaml)
list(SORT sensor_files)
set(entries "")
foreach(file IN LISTS sensor_files)
  get_filename_component(name ${file} NAME_WE)
  file(READ ${file} text)
  string(APPEND entries "      {\"${name}\", R\"yaml(${text})yaml\"},\n")
  set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
endforeach()
file(GENERATE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/sensor_files.cpp CONTENT
"// Made from cfg/sensors by cmake/embed_sensors.cmake.
#include \"segdf/io/sensor_files.hpp\"

namespace segdf {

const std::map<std::string, std::string>& sensorFiles() {
  static const std::map<std::string, std::string> kFiles{
${entries}  };
  return kFiles;
}

}  // namespace segdf
")
