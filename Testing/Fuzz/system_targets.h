// Systems that are fuzzed, each with a small mesh and strokes made of the bytes.
#ifndef oversketch_testing_fuzz_system_targets_h
#define oversketch_testing_fuzz_system_targets_h

#include <string>

namespace oversketch_fuzz
{

void takeOneStroke(const std::string& bytes);
void takeAugment(const std::string& bytes);
void takeDrawing(const std::string& bytes);

} // namespace oversketch_fuzz
#endif
