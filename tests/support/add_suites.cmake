# Makes each suite of the test program `program` a test of CTest, when CTest starts.
if(NOT EXISTS "${program}")
  add_test(${folder}_NOT_BUILT ${folder}_NOT_BUILT)
  set_tests_properties(${folder}_NOT_BUILT PROPERTIES LABELS ${label})
  return()
endif()
execute_process(COMMAND "${program}" --gtest_list_tests --gtest_filter=-Long*
                OUTPUT_VARIABLE listed RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "${program} does not list its tests: ${failed}")
endif()
string(REGEX MATCHALL "\n[^ \n]+\\.[ \n]" suites "${listed}")
foreach(suite ${suites})
  string(REGEX MATCH "[^ \n]+\\." suite "${suite}")
  string(REGEX REPLACE "\\.$" "" suite "${suite}")
  add_test("${folder}/${suite}" "${program}" "--gtest_filter=${suite}.*")
  # A suite ends with the name of a skipped test only when none failed.
  set_tests_properties("${folder}/${suite}" PROPERTIES
    LABELS ${label} TIMEOUT ${timeout} PROCESSOR_AFFINITY ON
    SKIP_REGULAR_EXPRESSION "\\[  SKIPPED \\] [^ \n]+\n*$")
endforeach()
