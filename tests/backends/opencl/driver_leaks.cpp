// Tells LeakSanitizer that PoCL loses a few bytes when a program does not compile.
extern "C" const char* __lsan_default_suppressions();  // NOLINT: the sanitizer's name for it
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libpocl\n";
}  // NOLINT
