# The targets inkedge_opencascade, the toolkits of OpenCASCADE 7.6 or later that read STEP, IGES and BREP, and
# inkedge_opencascade_writers, with those that tests make models with. They are found by hand: 7.8 joined some under new
# names, and Debian's CMake files want packages that are not needed here.
find_path(OPENCASCADE_INCLUDE_DIR STEPCAFControl_Reader.hxx PATH_SUFFIXES opencascade occt)
set(toolkits TKXCAF TKLCAF TKCAF TKCDF TKMesh TKShHealing TKTopAlgo TKGeomAlgo TKBRep TKGeomBase TKG3d TKG2d
    TKMath TKernel)
find_library(OPENCASCADE_TKDESTEP TKDESTEP)
if(OPENCASCADE_TKDESTEP)  # 7.8
  list(PREPEND toolkits TKDESTEP TKDEIGES TKXSBase)
else()
  list(PREPEND toolkits TKXDESTEP TKSTEP TKSTEPBase TKSTEPAttr TKSTEP209 TKXDEIGES TKIGES TKXSBase)
endif()
set(missing "")
function(inkedge_toolkits target)
  add_library(${target} INTERFACE)
  foreach(toolkit IN LISTS ARGN)
    find_library(OPENCASCADE_${toolkit} ${toolkit})
    mark_as_advanced(OPENCASCADE_${toolkit})
    if(NOT OPENCASCADE_${toolkit})
      list(APPEND missing ${toolkit})
    endif()
    target_link_libraries(${target} INTERFACE ${OPENCASCADE_${toolkit}})
  endforeach()
  set(missing ${missing} PARENT_SCOPE)
endfunction()
inkedge_toolkits(inkedge_opencascade ${toolkits})
inkedge_toolkits(inkedge_opencascade_writers TKFillet TKBool TKBO TKPrim)
target_link_libraries(inkedge_opencascade_writers INTERFACE inkedge_opencascade)
mark_as_advanced(OPENCASCADE_INCLUDE_DIR OPENCASCADE_TKDESTEP)
if(NOT OPENCASCADE_INCLUDE_DIR OR missing)
  message(FATAL_ERROR "expected OpenCASCADE 7.6 or later, found it without: "
    "${missing} ${OPENCASCADE_INCLUDE_DIR}; install libocct-data-exchange-dev, "
    "libocct-modeling-algorithms-dev and libocct-ocaf-dev, or set INKEDGE_CAD to OFF")
endif()
target_include_directories(inkedge_opencascade SYSTEM INTERFACE ${OPENCASCADE_INCLUDE_DIR})
