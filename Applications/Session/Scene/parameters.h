// Parameters of classes, for rows of the list of systems, and what a form and a command line make of them.
#ifndef oversketch_applications_session_scene_parameters_h
#define oversketch_applications_session_scene_parameters_h

#include "systems.h"

#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

// A property as parameter() and ofStep() ask for it: its name, and how it is set and got.
#define PROPERTY(T, name) #name, &T::Set##name, &T::Get##name

namespace oversketch_session
{

// For SystemRow::make.
template <typename T>
vtkSmartPointer<vtkOversketchSystem> make()
{
  return vtkSmartPointer<T>::New();
}

// A parameter of a step of the system, which does not repeat it; T is the step's class.
template <typename T, typename Setter, typename Getter>
Parameter ofStep(const std::string& step,
  const std::string& property,
  Setter setter,
  Getter getter,
  const std::string& word,
  const std::string& title,
  const std::string& help,
  std::vector<Choice> choices = {})
{
  const auto owner = [step](vtkOversketchSystem* system) { return static_cast<T*>(ownerOf(system, step)); };
  using Got = std::decay_t<decltype((std::declval<T&>().*getter)())>;
  constexpr bool isText = std::is_same_v<Got, const char*>, isTriple = std::is_same_v<Got, double*>;
  using Whole = std::conditional_t<isText, std::string, Got>;
  using Held = std::conditional_t<isTriple, std::vector<double>, Whole>;
  Parameter made;
  made.property = property;
  made.word = word;
  made.title = title;
  made.help = help;
  made.choices = std::move(choices);
  made.step = step;
  made.set = [owner, setter](vtkOversketchSystem* system, const Value& value)
  {
    if constexpr (isText)
    {
      (owner(system)->*setter)(std::get<Held>(value).c_str());
    }
    else if constexpr (isTriple)
    {
      (owner(system)->*setter)(std::get<Held>(value).data());
    }
    else
    {
      (owner(system)->*setter)(std::get<Held>(value));
    }
  };
  made.get = [owner, getter](vtkOversketchSystem* system) -> Value
  {
    const Got got = (owner(system)->*getter)();
    if constexpr (isTriple)
    {
      return Held(got, got + 3);
    }
    else
    {
      return Held(got);
    }
  };
  return made;
}

// A parameter of the system's own class.
template <typename T, typename Setter, typename Getter>
Parameter parameter(const std::string& property,
  Setter setter,
  Getter getter,
  const std::string& word,
  const std::string& title,
  const std::string& help,
  std::vector<Choice> choices = {})
{
  return ofStep<T>("", property, setter, getter, word, title, help, std::move(choices));
}

// A parameter of the system's own class that is three numbers.
template <typename T>
Parameter triple(const std::string& property,
  void (T::*setter)(const double*),
  double* (T::*getter)(),
  const std::string& word,
  const std::string& title,
  const std::string& help)
{
  return parameter<T>(property, setter, getter, word, title, help);
}

// Adds what a form offers of a number.
inline Parameter between(double least, double most, Parameter made)
{
  made.least = least;
  made.most = most;
  return made;
}

// Adds what a form offers of a text.
inline Parameter offering(std::vector<Choice> offers, Parameter made)
{
  made.offers = std::move(offers);
  return made;
}

// Makes it a text that a command line takes from a file.
inline Parameter fromFile(Parameter made)
{
  made.isFile = true;
  return made;
}

// Makes it a text that a command line may add to.
inline Parameter listing(Parameter made)
{
  made.isList = true;
  return made;
}

// Makes it one that files of programs before it do not have.
inline Parameter later(Parameter made)
{
  made.isLater = true;
  return made;
}

// Makes one number stand for all where it is typed.
inline Parameter oneForAll(Parameter made)
{
  made.oneForAll = true;
  return made;
}

// Makes it one that has no effect without an input.
inline Parameter actingWith(const std::string& input, Parameter made)
{
  made.actsWith = input;
  return made;
}

// Makes it a length.
inline Parameter length(Parameter made)
{
  made.isLength = true;
  return made;
}

} // namespace oversketch_session
#endif
