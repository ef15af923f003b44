#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| raystep_tests::fuzz::walks(bytes));
