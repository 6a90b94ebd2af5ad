# The OpenGL 3.3 core loader, with what compute shaders need, generated at build time by the distribution's glad 2 (python3-glad): target glad.
find_program(GLAD_EXECUTABLE glad PATHS /usr/bin NO_DEFAULT_PATH)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(glad REQUIRED_VARS GLAD_EXECUTABLE)
if(glad_FOUND AND NOT TARGET glad)
  set(_glad_dir ${CMAKE_BINARY_DIR}/glad)
  add_custom_command(
    OUTPUT ${_glad_dir}/src/gl.c ${_glad_dir}/include/glad/gl.h
    COMMAND ${GLAD_EXECUTABLE} --quiet --reproducible --api gl:core=3.3
            --extensions GL_KHR_debug,GL_ARB_timer_query,GL_ARB_compute_shader,GL_ARB_shader_image_load_store,GL_ARB_shader_storage_buffer_object
            --out-path ${_glad_dir} c
    COMMENT "Generating the OpenGL 3.3 core loader")
  add_library(glad STATIC ${_glad_dir}/src/gl.c)
  target_include_directories(glad SYSTEM PUBLIC ${_glad_dir}/include)
  set_target_properties(glad PROPERTIES POSITION_INDEPENDENT_CODE ON)
endif()
mark_as_advanced(GLAD_EXECUTABLE)
