# find_package(Finback): the programs and finback_firmware(), which builds a firmware of one's own.
# Lies in PREFIX/lib/cmake/Finback; everything else is found from there.
get_filename_component(FINBACK_PREFIX ${CMAKE_CURRENT_LIST_DIR}/../../.. ABSOLUTE)
set(FINBACK_PROGRAM ${FINBACK_PREFIX}/bin/finback)
set(FINBACK_CC ${FINBACK_PREFIX}/bin/finback-cc)
set(FINBACK_RUNTIME ${FINBACK_PREFIX}/share/finback/runtime)

# finback_firmware(NAME SOURCES c... [RUNTIME units...] [FILES files...] [OPTIONS options...])
#
# Fills the folder NAME of the build with the units of a firmware: SOURCES compiled by finback-cc with
# OPTIONS (default: -O2), RUNTIME units of the installation (start_a.bir, memory.bir, ...), and FILES as
# they are: its firmware.toml, its placement, hand-written BIR. Run it with
# finback run --firmware BUILD/NAME. Headers: -I in OPTIONS; a change of one below the current folder builds anew.
function(finback_firmware name)
  cmake_parse_arguments(ARG "" "" "SOURCES;RUNTIME;FILES;OPTIONS" ${ARGN})
  if(NOT ARG_OPTIONS)
    set(ARG_OPTIONS -O2)
  endif()
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/${name})
  file(MAKE_DIRECTORY ${folder})
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.h)
  set(units)
  foreach(source ${ARG_SOURCES})
    get_filename_component(unit ${source} NAME_WE)
    set(unit ${folder}/${unit}.bir)
    # Run in this folder, so that the lines of the source are known by short names.
    add_custom_command(
      OUTPUT ${unit}
      COMMAND ${FINBACK_CC} ${ARG_OPTIONS} -o ${unit} ${source}
      WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}
      DEPENDS ${FINBACK_CC} ${source} ${headers}
      COMMENT "Firmware ${name}: ${source}" VERBATIM)
    list(APPEND units ${unit})
  endforeach()
  list(TRANSFORM ARG_RUNTIME PREPEND ${FINBACK_RUNTIME}/)
  list(TRANSFORM ARG_FILES PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
  foreach(file ${ARG_RUNTIME} ${ARG_FILES})
    get_filename_component(unit ${file} NAME)
    set(unit ${folder}/${unit})
    add_custom_command(OUTPUT ${unit} COMMAND ${CMAKE_COMMAND} -E copy ${file} ${unit}
                       DEPENDS ${file} COMMENT "Firmware ${name}: ${file}" VERBATIM)
    list(APPEND units ${unit})
  endforeach()
  add_custom_target(${name} ALL DEPENDS ${units})
endfunction()
