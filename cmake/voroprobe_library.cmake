# voroprobe_library(NAME SOURCES a.cpp b.cpp ... [PUBLIC target ...] [PRIVATE target ...])
#
# One folder, one static library `voroprobe_NAME` with the alias `voroprobe::NAME`. Headers are included as "folder/header.h":
# src/ and the top of the repository are on the include path. PUBLIC are other folders; third parties are PRIVATE.
function(voroprobe_library name)
    cmake_parse_arguments(arg "" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
    set(target voroprobe_${name})
    add_library(${target} STATIC ${arg_SOURCES})
    add_library(voroprobe::${name} ALIAS ${target})
    set_target_properties(${target} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
    target_compile_features(${target} PUBLIC cxx_std_20)
    target_link_libraries(${target} PUBLIC ${arg_PUBLIC} PRIVATE ${arg_PRIVATE})
    target_include_directories(${target} PUBLIC
        $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
        $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>
        $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/voroprobe>)
    voroprobe_warnings(${target})
    if(VOROPROBE_BUILD_TESTS)
        voroprobe_check_headers(${name})
    endif()
endfunction()

# Warnings on our own targets only; errors by preset (VOROPROBE_WARNINGS_AS_ERRORS).
function(voroprobe_warnings target)
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual)
    if(VOROPROBE_WARNINGS_AS_ERRORS)
        target_compile_options(${target} PRIVATE -Werror)
    endif()
endfunction()

# Every header of the current folder compiles on its own, and twice: a generated source each. That it builds is the test.
function(voroprobe_check_headers name)
    file(GLOB headers CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} *.h)
    set(sources)
    foreach(header ${headers})
        set(source ${CMAKE_CURRENT_BINARY_DIR}/headers_alone/${header}.cpp)
        file(CONFIGURE OUTPUT ${source} CONTENT "#include \"${name}/${header}\"\n#include \"${name}/${header}\"\n")
        list(APPEND sources ${source})
    endforeach()
    if(sources)
        add_library(voroprobe_headers_of_${name} OBJECT ${sources})
        voroprobe_warnings(voroprobe_headers_of_${name})
        target_link_libraries(voroprobe_headers_of_${name} PRIVATE
            voroprobe::${name} $<TARGET_PROPERTY:voroprobe_${name},LINK_LIBRARIES>)
        # Folders of third parties alone: warnings in ours must show.
        string(REGEX REPLACE "([][+.*()^?$|])" "\\\\\\1" ours "${PROJECT_SOURCE_DIR}")
        target_include_directories(voroprobe_headers_of_${name} SYSTEM PRIVATE
            $<FILTER:$<TARGET_PROPERTY:voroprobe_${name},INCLUDE_DIRECTORIES>,EXCLUDE,^${ours}>)
    endif()
endfunction()
