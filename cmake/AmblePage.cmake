# The program of the pages that viz/page writes: three.js, of npm, and viz/page/web, bundled by esbuild into one text a
# kind. Neither is needed afterwards: the library holds the texts.
find_program(AMBLE_NPM npm)
find_program(AMBLE_ESBUILD esbuild)
foreach(tool NPM ESBUILD)
  if(NOT AMBLE_${tool})
    string(TOLOWER ${tool} name)
    message(FATAL_ERROR "${name} was not found; expected Debian's package of that name: scripts/setup installs it")
  endif()
endforeach()

# Into `out`: the folder in which the build makes page.html, page.css and page.js; `target` is built after them.
function(amble_page target out)
  set(web "${PROJECT_SOURCE_DIR}/viz/page/web")
  set(made "${PROJECT_BINARY_DIR}/web")
  set(installed "${made}/node_modules/.package-lock.json")
  file(GLOB sources CONFIGURE_DEPENDS "${web}/*.js" "${web}/*.css")
  add_custom_command(
    OUTPUT "${installed}"
    COMMAND ${CMAKE_COMMAND} -E copy "${web}/package.json" "${web}/package-lock.json" "${made}"
    COMMAND "${AMBLE_NPM}" ci --ignore-scripts --no-audit --no-fund --loglevel=error
    COMMAND ${CMAKE_COMMAND} -E touch "${installed}"
    DEPENDS "${web}/package.json" "${web}/package-lock.json"
    WORKING_DIRECTORY "${made}" COMMENT "Fetching three.js" VERBATIM)
  add_custom_command(
    OUTPUT "${made}/page.js" "${made}/page.css" "${made}/page.html"
    COMMAND ${CMAKE_COMMAND} -E env "NODE_PATH=${made}/node_modules" "${AMBLE_ESBUILD}" "${web}/main.js"
            --bundle --minify --format=iife --target=es2022 --charset=ascii --log-level=warning
            "--outfile=${made}/page.js"
    COMMAND "${AMBLE_ESBUILD}" "${web}/page.css" --bundle --minify --log-level=warning "--outfile=${made}/page.css"
    COMMAND ${CMAKE_COMMAND} -E copy "${web}/page.html" "${made}/page.html"
    DEPENDS ${sources} "${web}/page.html" "${installed}" COMMENT "Bundling the page" VERBATIM)
  file(MAKE_DIRECTORY "${made}")
  add_custom_target(${target}_web DEPENDS "${made}/page.js" "${made}/page.css" "${made}/page.html")
  add_dependencies(${target} ${target}_web)
  set(${out} "${made}" PARENT_SCOPE)
endfunction()
