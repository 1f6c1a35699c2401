// Values that a command line gives for its options: words, numbers and places read from text. All throw
// BadUse, naming the option.
#ifndef oversketch_applications_command_option_values_h
#define oversketch_applications_command_option_values_h

#include "options.h"

#include <array>
#include <string>
#include <vector>

namespace oversketch_command
{

// "a, b, c"
std::string listOf(const std::vector<std::string>& words, const std::string& between);

// The number of the choice.
int choiceOf(const std::string& option, const std::string& value, const std::vector<std::string>& choices);
// "1,2.5", each finite.
std::vector<double> numbersOf(const std::string& option, const std::string& text);

// Whether a line's input was given as places, "0 0, 0.4 0.3, 1 0", and not as a file.
bool isPlaces(const oversketch_session::SystemInput& input, const std::string& given);
std::vector<std::array<double, 2>> placesOf(const std::string& option, const std::string& text);

// Whether it is given without a value, and is then on.
bool isSwitch(const oversketch_session::Parameter& parameter);
// A value of the kind that the parameter's default is; of lengths also as a share of the mesh's size: "3%".
void takeValue(Options& options,
  const oversketch_session::Parameter& parameter,
  const std::string& option,
  const std::string& text);
// Both values of a pair, "64x48"; of one alone the second is the default.
void takePair(Options& options,
  const oversketch_session::Pair& pair,
  const std::string& option,
  const std::string& text);
// "0.5,n,3%" for the fields of a phrase.
void takePhrase(Options& options,
  const oversketch_session::Phrase& phrase,
  const std::string& option,
  const std::string& text);

} // namespace oversketch_command
#endif
