# Catalogues of the words that people read, resources/translations/kickstand_<language>.ts: compiled where Qt's
# tools are there, and without them the program speaks the language of its sources. The target
# update_translations brings the catalogues up to the sources; nothing else writes to the source tree.

find_package(Qt6 QUIET COMPONENTS LinguistTools)

# kickstand_translations(TARGET): the catalogues stand beside this program, in translations/.
function(kickstand_translations target)
  if(NOT TARGET Qt6::lrelease)
    return()
  endif()
  file(GLOB catalogues CONFIGURE_DEPENDS "${CMAKE_SOURCE_DIR}/resources/translations/kickstand_*.ts")
  set(compiled)
  foreach(catalogue IN LISTS catalogues)
    get_filename_component(name "${catalogue}" NAME_WE)
    set(output "${CMAKE_BINARY_DIR}/app/translations/${name}.qm")
    add_custom_command(OUTPUT "${output}"
      COMMAND ${CMAKE_COMMAND} -E make_directory "${CMAKE_BINARY_DIR}/app/translations"
      COMMAND Qt6::lrelease -silent "${catalogue}" -qm "${output}"
      DEPENDS "${catalogue}" VERBATIM)
    list(APPEND compiled "${output}")
  endforeach()
  add_custom_target(${target}_translations DEPENDS ${compiled})
  add_dependencies(${target} ${target}_translations)
  install(FILES ${compiled} DESTINATION share/kickstand/translations)
  add_custom_target(update_translations
    COMMAND Qt6::lupdate -silent -locations none -no-obsolete -I . -tr-function-alias QT_TRANSLATE_NOOP+=FAULT_TEXT
      app core/engine core/thunderbots/wire/faults.cpp ui -ts ${catalogues}
    WORKING_DIRECTORY "${CMAKE_SOURCE_DIR}" VERBATIM)
endfunction()
