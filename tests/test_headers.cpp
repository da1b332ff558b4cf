// The one source file of the target that compiles GoogleTest's headers for all test programs.
