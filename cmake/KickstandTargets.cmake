# What every target of the project shares: the language level, the include root, warnings and sanitizers, and
# the shape "one static library a folder".

add_library(kickstand_options INTERFACE)
target_compile_features(kickstand_options INTERFACE cxx_std_20)
target_include_directories(kickstand_options INTERFACE "${CMAKE_SOURCE_DIR}")
target_compile_options(kickstand_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual -Wcast-align -Wconversion
  -Wno-sign-conversion -Wformat=2 -Wimplicit-fallthrough
  $<$<BOOL:${KICKSTAND_WERROR}>:-Werror>)
if(KICKSTAND_SANITIZE)
  target_compile_options(kickstand_options INTERFACE
    -fsanitize=${KICKSTAND_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(kickstand_options INTERFACE -fsanitize=${KICKSTAND_SANITIZE})
endif()

# kickstand_library(NAME SOURCES file... [DEPENDS target...] [PRIVATE_DEPENDS target...])
function(kickstand_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS;PRIVATE_DEPENDS" ${ARGN})
  add_library(${name} STATIC ${ARG_SOURCES})
  target_link_libraries(${name} PUBLIC kickstand_options ${ARG_DEPENDS} PRIVATE ${ARG_PRIVATE_DEPENDS})
endfunction()

# The tests labelled "threads": all that the thread sanitizer's build needs.
add_custom_target(thread_tests)

# Tests that run a window or a program work in real time, with threads that must all come to their turn: on a busy
# machine they would measure the machine.
set(KICKSTAND_BUSY_LABELS ui program)

# kickstand_test(NAME SOURCES file... DEPENDS target... [LABELS label...] [LAUNCHER command...] [ENVIRONMENT VAR=VALUE...])
# One GoogleTest program, registered with ctest as one test of the same name.
function(kickstand_test name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS;LABELS;LAUNCHER;ENVIRONMENT" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE kickstand_options ${ARG_DEPENDS} GTest::gtest_main)
  add_test(NAME ${name} COMMAND ${ARG_LAUNCHER} $<TARGET_FILE:${name}>)
  set_tests_properties(${name} PROPERTIES TIMEOUT 900 LABELS "${ARG_LABELS}")
  foreach(label IN LISTS KICKSTAND_BUSY_LABELS)
    if(label IN_LIST ARG_LABELS)
      set_tests_properties(${name} PROPERTIES PROCESSORS 2)
    endif()
  endforeach()
  if("threads" IN_LIST ARG_LABELS)
    add_dependencies(thread_tests ${name})
  endif()
  if(ARG_ENVIRONMENT)
    set_tests_properties(${name} PROPERTIES ENVIRONMENT "${ARG_ENVIRONMENT}")
  endif()
endfunction()
