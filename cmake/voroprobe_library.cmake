# voroprobe_library(NAME SOURCES a.cpp b.cpp [PUBLIC target ...] [PRIVATE target ...])
#
# One folder, one static library `voroprobe_NAME` with the alias `voroprobe::NAME`. A folder without sources is an interface
# library. Headers are included as "folder/header.h": src/ and the top of the repository are on the include path.
function(voroprobe_library name)
    cmake_parse_arguments(arg "" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
    set(target voroprobe_${name})
    if(arg_SOURCES)
        add_library(${target} STATIC ${arg_SOURCES})
        set(scope PUBLIC)
        voroprobe_warnings(${target})
        target_link_libraries(${target} PRIVATE ${arg_PRIVATE})
    else()
        add_library(${target} INTERFACE)
        set(scope INTERFACE)
    endif()
    add_library(voroprobe::${name} ALIAS ${target})
    set_target_properties(${target} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
    target_compile_features(${target} ${scope} cxx_std_20)
    target_link_libraries(${target} ${scope} ${arg_PUBLIC})
    target_include_directories(${target} ${scope}
        $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
        $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>
        $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/voroprobe>)
endfunction()

# Warnings on our own targets only; errors by preset (VOROPROBE_WARNINGS_AS_ERRORS).
function(voroprobe_warnings target)
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual)
    if(VOROPROBE_WARNINGS_AS_ERRORS)
        target_compile_options(${target} PRIVATE -Werror)
    endif()
endfunction()
