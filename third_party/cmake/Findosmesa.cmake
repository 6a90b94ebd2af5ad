# OSMesa is opened at run time and never linked; this only tells the person who builds whether it is there.
find_library(OSMESA_LIBRARY NAMES OSMesa libOSMesa.so.8 libOSMesa.so.6)
if(OSMESA_LIBRARY)
  message(STATUS "OSMesa: found (${OSMESA_LIBRARY}), used at run time beside EGL")
else()
  message(STATUS "OSMesa: not found (it left Mesa in 25.1); EGL is used alone and OSMesa tests say that they skip")
endif()
mark_as_advanced(OSMESA_LIBRARY)
set(osmesa_FOUND TRUE)
