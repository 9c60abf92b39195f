# inkedge_add_image_test(NAME name MODEL file REFERENCE file [MAP map] [SETTINGS --flag value...] [SHARE share]
#                        [LEVEL level] [HARD_LIMIT limit] | [LINES] [DISTANCE px] [SPECK px]
#                        [FOLDER folder] [COMMAND command])
#
# A test that draws a model as `inkedge render MODEL SETTINGS...` does and compares what is drawn with a reference, by
# `inkedge compare`:
#   NAME        of the test
#   MODEL       any file that inkedge reads
#   SETTINGS    flags of inkedge render but the output: --view iso --size 640x480
#   REFERENCE   a picture; with LINES lines as .svg or .json, or a picture. Its extension is the candidate's
#   MAP         that map of the picture in its stead, as for --maps
#   LEVEL, HARD_LIMIT  of pixels, 0 to 1 [0; no limit where a share is allowed, else the level]
#   LINES       compares lines, not pixels: those that run along each other within DISTANCE [1.5] are the same, changes
#               shorter than SPECK [4] are left out
#   SHARE       of the pixels over the level, or of the length of lines, that may change, 0 to 1 [0]
#   FOLDER      where the candidate and the difference are left [image_tests in the current binary folder]
#   COMMAND     the command [inkedge_COMMAND, that of the package]
#
# A difference, or a reference that is missing, fails the test and leaves both. Building the target inkedge_accept_NAME
# makes the candidate the reference, inkedge_accept those of all these tests: look at them first.
function(inkedge_add_image_test)
  cmake_parse_arguments(PARSE_ARGV 0 test "LINES"
                        "NAME;MODEL;REFERENCE;MAP;SHARE;LEVEL;HARD_LIMIT;DISTANCE;SPECK;FOLDER;COMMAND" "SETTINGS")
  foreach(needed IN ITEMS NAME MODEL REFERENCE)
    if(NOT test_${needed})
      message(FATAL_ERROR "inkedge_add_image_test: expected ${needed}, found none")
    endif()
  endforeach()
  if(test_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "inkedge_add_image_test: expected what it takes, found ${test_UNPARSED_ARGUMENTS}")
  endif()
  if(NOT test_COMMAND)
    set(test_COMMAND ${inkedge_COMMAND})
  endif()
  if(NOT test_COMMAND)
    message(FATAL_ERROR "inkedge_add_image_test: expected the command inkedge beside the package, found none; install "
                        "it, or name it after COMMAND")
  endif()
  if(NOT test_FOLDER)
    set(test_FOLDER ${CMAKE_CURRENT_BINARY_DIR}/image_tests)
  endif()
  get_filename_component(model ${test_MODEL} ABSOLUTE)
  get_filename_component(reference ${test_REFERENCE} ABSOLUTE)
  get_filename_component(extension ${reference} LAST_EXT)
  set(candidate ${test_FOLDER}/${test_NAME}${extension})
  set(difference ${test_FOLDER}/${test_NAME}.difference.png)
  set(compare "")
  if(test_LINES)
    list(APPEND compare --lines)
    set(difference ${test_FOLDER}/${test_NAME}.difference.svg)
  endif()
  foreach(tolerance IN ITEMS SHARE LEVEL HARD_LIMIT DISTANCE SPECK)
    if(DEFINED test_${tolerance})
      string(TOLOWER --${tolerance} flag)
      string(REPLACE _ - flag ${flag})
      list(APPEND compare ${flag} ${test_${tolerance}})
    endif()
  endforeach()

  set(script ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/inkedgeRunImageTest.cmake)
  # A list is one argument of the test's command line; a bar stands between its elements.
  list(JOIN test_SETTINGS "|" settings)
  list(JOIN compare "|" compare)
  add_test(NAME ${test_NAME}
           COMMAND ${CMAKE_COMMAND} -DINKEDGE=${test_COMMAND} -DMODEL=${model} -DREFERENCE=${reference}
                   -DCANDIDATE=${candidate} -DDIFFERENCE=${difference} -DMAP=${test_MAP} -DSETTINGS=${settings}
                   -DCOMPARE=${compare} -DACCEPT=inkedge_accept_${test_NAME} -P ${script})
  add_custom_target(inkedge_accept_${test_NAME} VERBATIM
                    COMMAND ${CMAKE_COMMAND} -DREFERENCE=${reference} -DCANDIDATE=${candidate} -DTAKE=ON -P ${script})
  if(NOT TARGET inkedge_accept)
    add_custom_target(inkedge_accept)
  endif()
  add_dependencies(inkedge_accept inkedge_accept_${test_NAME})
endfunction()
