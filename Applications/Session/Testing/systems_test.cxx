// The list of systems, compared with the classes and their headers: nothing that a class lets be set is
// forgotten, and what the list says is so.
#include "systems.h"

#include "vtkOversketchSystem.h"

#include "vtkAlgorithm.h"
#include "vtkInformation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <regex>
#include <set>

namespace fs = std::filesystem;
using namespace oversketch_session;

namespace
{

// The public part of a system's header, without comments.
std::string headerOf(const SystemRow& row)
{
  for (const fs::directory_entry& room : fs::directory_iterator(OVERSKETCH_FILTERS_FOLDER))
  {
    std::ifstream stream(room.path() / ("vtkOversketch" + row.name + ".h"));
    if (stream)
    {
      std::string text{ std::istreambuf_iterator<char>(stream), {} };
      for (const auto& [begin, end] : { std::pair("/*", "*/"), std::pair("//", "\n") })
      {
        for (std::size_t at = text.find(begin); at != std::string::npos; at = text.find(begin, at))
        {
          text.erase(at, text.find(end, at) + std::string(end).size() - at);
        }
      }
      return text.substr(text.find("public:"), text.find("protected:") - text.find("public:"));
    }
  }
  ADD_FAILURE() << "there is no header of " << row.name;
  return {};
}

std::set<std::string> found(const std::string& text, const std::string& pattern)
{
  std::set<std::string> names;
  const std::regex expression(pattern);
  for (std::sregex_iterator it(text.begin(), text.end(), expression), end; it != end; ++it)
  {
    names.insert((*it)[1]);
  }
  return names;
}

// What has SetX and GetX, as methods or as VTK's macros, in the class's own header.
std::set<std::string> parametersOf(const std::string& header)
{
  std::set<std::string> set = found(header, "\\bSet(\\w+)\\("), get = found(header, "\\bGet(\\w+)\\(");
  set.merge(found(header, "\\bvtkSet\\w*Macro\\((\\w+),"));
  get.merge(found(header, "\\bvtkGet\\w*Macro\\((\\w+),"));
  std::set<std::string> both;
  std::set_intersection(set.begin(), set.end(), get.begin(), get.end(), std::inserter(both, both.begin()));
  return both;
}

std::string plain(std::string text)
{
  text.erase(std::remove(text.begin(), text.end(), '-'), text.end());
  std::transform(text.begin(),
    text.end(),
    text.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

} // namespace

TEST(Systems, EveryParameterOfTheHeaderIsInTheListOrLeftOutWithAReason)
{
  int count = 0;
  for (const SystemRow& row : systems())
  {
    std::set<std::string> told;
    const auto fresh = row.make();
    for (const Parameter& parameter : row.parameters)
    {
      if (parameter.step.empty())
      {
        EXPECT_TRUE(told.insert(parameter.property).second) << parameter.property << " is told twice";
      }
      else
      {
        EXPECT_TRUE(fresh->GetStep(parameter.step.c_str())) << parameter.step;
      }
    }
    for (const auto& [property, reason] : row.leftOut)
    {
      EXPECT_TRUE(told.insert(property).second) << property << " is in the list and left out";
      EXPECT_FALSE(reason.empty()) << property;
    }
    EXPECT_EQ(told, parametersOf(headerOf(row))) << row.name;
    count += static_cast<int>(row.parameters.size());
  }
  std::cout << systems().size() << " systems, " << count << " parameters\n";
}

TEST(Systems, DefaultsAndChoicesAreThoseOfTheClass)
{
  for (const SystemRow& row : systems())
  {
    const auto fresh = row.make();
    const std::string header = headerOf(row);
    EXPECT_EQ(std::string(fresh->GetClassName()), "vtkOversketch" + row.name);
    for (const Parameter& parameter : row.parameters)
    {
      SCOPED_TRACE(row.name + "." + parameter.property);
      EXPECT_EQ(parameter.get(fresh), parameter.initial);
      EXPECT_NE(plain(parameter.property).find(plain(parameter.word)), std::string::npos) << "one spelling";
      EXPECT_FALSE(parameter.title.empty() || parameter.help.empty());
      EXPECT_NE(parameter.help.back(), '.');
      // Named setters are the choices, and no other value is taken.
      std::set<std::string> words;
      for (const Choice& choice : parameter.choices)
      {
        words.insert(plain(choice.word));
        EXPECT_FALSE(choice.title.empty());
      }
      std::set<std::string> named;
      for (const std::string& name : found(header, "\\bSet" + parameter.property + "To(\\w+)\\("))
      {
        named.insert(plain(name));
      }
      EXPECT_EQ(words, named);
      if (!parameter.choices.empty())
      {
        constexpr int huge = std::numeric_limits<int>::max();
        parameter.set(fresh, -huge);
        EXPECT_EQ(parameter.get(fresh), Value(0));
        parameter.set(fresh, huge);
        EXPECT_EQ(parameter.get(fresh), Value(static_cast<int>(parameter.choices.size()) - 1));
      }
      // A value other than the default is kept, and the default comes back.
      if (std::holds_alternative<bool>(parameter.initial))
      {
        const Value other = !std::get<bool>(parameter.initial);
        parameter.set(fresh, other);
        EXPECT_EQ(parameter.get(fresh), other);
      }
      parameter.set(fresh, parameter.initial);
      EXPECT_EQ(parameter.get(fresh), parameter.initial);
    }
  }
}

// The word of a choice stands at the place of its value.
TEST(Systems, ChoicesStandInTheOrderOfTheirValues)
{
  for (const SystemRow& row : systems())
  {
    const std::string header = headerOf(row);
    for (const Parameter& parameter : row.parameters)
    {
      for (std::size_t i = 0; i < parameter.choices.size(); ++i)
      {
        // RemeshAuto, or Surface alone where no other parameter has it
        const std::string enumerator = "(?:" + parameter.property + ")?" + parameter.choices[i].word;
        std::smatch match;
        const bool named = std::regex_search(
          header, match, std::regex("\\b" + enumerator + "\\s*=\\s*(\\d+)", std::regex::icase));
        ASSERT_TRUE(named) << row.name << " has no " << enumerator;
        EXPECT_EQ(match[1], std::to_string(i)) << enumerator;
      }
    }
  }
}

TEST(Systems, InputsAreThePortsOfTheClass)
{
  for (const SystemRow& row : systems())
  {
    const auto fresh = row.make();
    ASSERT_EQ(static_cast<int>(row.inputs.size()), fresh->GetNumberOfInputPorts()) << row.name;
    std::set<int> ports;
    for (const SystemInput& input : row.inputs)
    {
      SCOPED_TRACE(row.name + ", " + input.name);
      EXPECT_TRUE(ports.insert(input.port).second);
      vtkInformation* info = fresh->GetInputPortInformation(input.port);
      ASSERT_NE(info, nullptr);
      EXPECT_EQ(input.optional, info->Has(vtkAlgorithm::INPUT_IS_OPTIONAL()) != 0);
      const std::string type = info->Get(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
      EXPECT_EQ(type, isImage(input.kind) ? "vtkImageData" : "vtkPolyData");
      EXPECT_FALSE(input.help.empty());
    }
    EXPECT_EQ(plain(row.name).rfind(plain(row.verb), 0), 0u) << "the name begins with the verb";
    EXPECT_EQ(findSystem(row.name), &row);
    EXPECT_EQ(findVerb(row.verb), &row);
    if (row.mirroring != Mirroring::None)
    {
      EXPECT_NE(findInput(row, SystemInput::Kind::Mesh), nullptr);
      EXPECT_EQ(faultOf({ row.name, row.keepingPoints, {}, MirrorPlane(), std::nullopt }), "");
    }
  }
  EXPECT_EQ(findSystem("Nothing"), nullptr);
}
