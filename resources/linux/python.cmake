# The files of the package python3-asperity: the module for the system's Python 3, the tutorial and
# the examples. Included by CMakeLists.txt; sets what cpack has to know.
set(python_component python)
set(modules lib/python3/dist-packages/asperity)
set(documents ${CMAKE_INSTALL_DATADIR}/doc/python3-asperity)
set(python_sources ${PROJECT_SOURCE_DIR}/app/python)
add_dependencies(package_files asperity_python)

install(TARGETS asperity_python LIBRARY DESTINATION ${modules} COMPONENT python)
install(DIRECTORY ${python_sources}/asperity/ DESTINATION ${modules} COMPONENT python
        FILES_MATCHING PATTERN *.py PATTERN *.pyi PATTERN py.typed PATTERN __pycache__ EXCLUDE)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/resources/scenes DESTINATION ${modules} COMPONENT python
        FILES_MATCHING PATTERN *.json)
install(DIRECTORY ${python_sources}/examples DESTINATION ${documents} COMPONENT python
        PATTERN __pycache__ EXCLUDE)
install(FILES copyright DESTINATION ${documents} COMPONENT python)
install(FILES ${changes} DESTINATION ${documents} COMPONENT python OPTIONAL)

# The module fits the minor version of Python that it was built for, and one interface of numpy.
execute_process(COMMAND ${ASPERITY_PYTHON_PROGRAM} -c
  "import sys; print('%d.%d;%d.%d' % (*sys.version_info[:2], sys.version_info[0], sys.version_info[1] + 1))"
  OUTPUT_VARIABLE versions OUTPUT_STRIP_TRAILING_WHITESPACE)
list(GET versions 0 this_python)
list(GET versions 1 next_python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-asperity)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
    "python3 (>= ${this_python}), python3 (<< ${next_python}), python3-numpy, python3-numpy-abi9")
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "asperity")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "jupyter-notebook, python3-emcee, python3-openturns")
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
    ${CMAKE_CURRENT_LIST_DIR}/python/postinst ${CMAKE_CURRENT_LIST_DIR}/python/prerm)
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_STRICT_PERMISSION TRUE)
set(CPACK_DEBIAN_PYTHON_DESCRIPTION
"friction of rubber on a rough line (Python 3 module)
Asperity computes how a viscoelastic elastomer slides over a randomly rough
line, after Li et al., Phys. Rev. Lett. 111, 034301 (2013). This package gives
its friction curves, contacts, motions, maps and fits to Python as arrays of
numpy. Pictures in notebooks are drawn by the program of the package asperity.")
