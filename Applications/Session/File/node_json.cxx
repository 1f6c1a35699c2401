#include "node_json.h"

#include "files.h"
#include "heights.h"
#include "mesh_file.h"
#include "parts.h"
#include "texture.h"
#include "vtkOversketchFilterTools.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace oversketch_session
{

using oversketch_files::Failed;

namespace
{

constexpr int largest = std::numeric_limits<int>::max();
constexpr int largestId = 1000000000;

// Version 1 knows one system, with one input and these parameters: member and property.
const char* const system1 = "OneStroke";
const char* const stroke1 = "Stroke";
constexpr std::pair<const char*, const char*> members1[] = { { "remesh", "Remesh" },
  { "adjust_normals", "AdjustNormals" },
  { "as_published", "AsPublished" } };

// A step holds no value that is the default.
void setValue(Step& step, const JsonReader& values, const std::string& name, const Parameter& parameter)
{
  const Value value = valueOf(values, name, parameter);
  if (value != parameter.initial)
  {
    step.values[parameter.property] = value;
  }
}

Json::Value jsonOfInput(const Input& input, const EntryWriter& entries)
{
  Json::Value json;
  if (const auto* lines = std::get_if<Lines>(&input))
  {
    json["lines"] = entries.lines(*lines);
  }
  else if (const auto* image = std::get_if<Image>(&input))
  {
    json["image"] = entries.image(*image);
    json["image_name"] = image->name;
  }
  else
  {
    json["step"] = std::get<StepOutput>(input).step;
    json["port"] = std::get<StepOutput>(input).port;
  }
  return json;
}

Image imageOf(const JsonReader& json, EntryReader& entries)
{
  return { json.text("image_name"), entries.picture(json.text("image")) };
}

Input inputOf(const JsonReader& json, SystemInput::Kind kind, EntryReader& entries)
{
  if (json.has("step"))
  {
    return StepOutput{ json.integer("step", 1, largestId), json.integer("port", 0, largest) };
  }
  if (kind == SystemInput::Kind::Heights)
  {
    return Image{ json.text("image_name"), entries.heights(json.text("image")) };
  }
  if (kind == SystemInput::Kind::Picture)
  {
    return imageOf(json, entries);
  }
  return entries.lines(json.text("lines"));
}

// Writes what both versions tell of a step alike.
void putCommon(Json::Value& json, const Node& node)
{
  json["name"] = node.name;
  json["on"] = node.on;
  if (node.step->mirror)
  {
    json["mirror"]["axis"] = node.step->mirror->axis;
    json["mirror"]["offset"] = node.step->mirror->offset;
  }
  if (node.committed)
  {
    json["section"]["middle"] = jsonList(node.committed->middle);
    json["section"]["length"] = node.committed->length;
  }
}

PartPlace partOf(const JsonReader& json)
{
  const JsonReader part = json.object("part");
  const std::vector<double> box = part.numbers("box");
  if (box.size() != 4)
  {
    part.refuse("box", "is not four numbers");
  }
  const PartPlace place{ { box[0], box[1], box[2], box[3] }, part.number("depth") };
  if (const std::string fault = faultOf(place); !fault.empty())
  {
    json.refuse("part", fault);
  }
  return place;
}

Node commonOf(const JsonReader& json, Step& step)
{
  if (json.has("mirror"))
  {
    const JsonReader mirror = json.object("mirror");
    step.mirror = MirrorPlane{ mirror.integer("axis", 0, 2), mirror.number("offset") };
  }
  Node node;
  node.name = json.text("name");
  node.on = json.yes("on");
  if (json.has("section"))
  {
    const JsonReader section = json.object("section");
    node.committed = Section{ section.point("middle"), section.number("length") };
  }
  return node;
}

constexpr double longestSide = 1e6; // px

std::optional<std::array<int, 2>> viewSizeOf(const JsonReader& json)
{
  if (!json.has("size"))
  {
    return std::nullopt;
  }
  const std::vector<double> size = json.numbers("size");
  const auto isLength = [](double length) { return length >= 1.0 && length <= longestSide; };
  if (size.size() != 2 || !isLength(size[0]) || !isLength(size[1]))
  {
    json.refuse("size", "is not two numbers from 1 to 1,000,000");
  }
  return std::array<int, 2>{ static_cast<int>(size[0]), static_cast<int>(size[1]) };
}

int upAxisOf(const JsonReader& json)
{
  const double axis = json.has("up_axis") ? json.number("up_axis") : 1.0;
  if (axis != 1.0 && axis != 2.0)
  {
    json.refuse("up_axis", "is neither 1 nor 2");
  }
  return static_cast<int>(axis);
}

} // namespace

const std::shared_ptr<const std::string>& EntryReader::bytes(const std::string& entry) const
{
  const auto it = this->Entries.find(entry);
  if (it == this->Entries.end())
  {
    throw Failed(this->Path + ": lacks its entry " + entry + "; the session is damaged");
  }
  return it->second;
}

Lines EntryReader::lines(const std::string& entry)
{
  auto it = this->Parsed.find(entry);
  if (it == this->Parsed.end())
  {
    const Lines parsed(oversketch_files::parseStroke(this->Path + ": " + entry, *this->bytes(entry)));
    it = this->Parsed.emplace(entry, parsed).first;
  }
  return it->second;
}

const std::shared_ptr<const std::string>& EntryReader::picture(const std::string& entry)
{
  const std::shared_ptr<const std::string>& bytes = this->bytes(entry);
  if (this->Pictures.insert(entry).second && !oversketch_files::pictureOf(*bytes))
  {
    throw Failed(this->Path + ": " + entry + " is " + oversketch_files::notAPicture);
  }
  return bytes;
}

const std::shared_ptr<const std::string>& EntryReader::heights(const std::string& entry)
{
  const std::shared_ptr<const std::string>& bytes = this->bytes(entry);
  if (this->Heights.insert(entry).second)
  {
    oversketch_files::parseHeights(this->Path + ": " + entry, *bytes);
  }
  return bytes;
}

Value valueOf(const JsonReader& values, const std::string& name, const Parameter& parameter)
{
  if (!parameter.choices.empty())
  {
    return values.choice(name, wordsOf(parameter));
  }
  struct Kinds
  {
    const JsonReader& values;
    const std::string& name;
    Value operator()(bool) const { return this->values.yes(this->name); }
    Value operator()(int) const { return this->values.integer(this->name, -largest, largest); }
    Value operator()(double) const { return this->values.number(this->name); }
    Value operator()(const std::vector<double>&) const { return this->values.numbers(this->name); }
    Value operator()(const std::string&) const { return this->values.text(this->name); }
  };
  return std::visit(Kinds{ values, name }, parameter.initial);
}

Json::Value jsonOf(const Parameter& parameter, const Value& value)
{
  struct Kinds
  {
    const std::vector<Choice>& choices;
    Json::Value operator()(bool yes) const { return yes; }
    Json::Value operator()(int number) const
    {
      return this->choices.empty() ? Json::Value(number)
                                   : Json::Value(this->choices[static_cast<std::size_t>(number)].word);
    }
    Json::Value operator()(double number) const { return number; }
    Json::Value operator()(const std::string& text) const { return text; }
    Json::Value operator()(const std::vector<double>& numbers) const { return jsonList(numbers); }
  };
  return std::visit(Kinds{ parameter.choices }, value);
}

bool isVersion1(const Session& session, const std::vector<SystemRow>& rows)
{
  const auto isKnown = [row = findSystem(system1, rows)](const auto& value)
  {
    const Parameter* parameter = row ? findParameter(*row, value.first) : nullptr;
    return std::any_of(std::begin(members1),
             std::end(members1),
             [&](const auto& member) { return value.first == member.second; }) ||
           (parameter && parameter->initial == value.second);
  };
  const auto isStroke = [&](const Node& node)
  {
    const Step& step = *node.step;
    return step.system == system1 && step.inputs.size() == 1 && step.inputs.count(stroke1) == 1 &&
           std::holds_alternative<Lines>(step.inputs.at(stroke1)) &&
           std::all_of(step.values.begin(), step.values.end(), isKnown);
  };
  return session.mesh && session.pictures.empty() && session.others.empty() && session.shown &&
         !session.locked && session.hidden.empty() &&
         std::all_of(session.nodes.begin(), session.nodes.end(), isStroke);
}

Json::Value jsonOf1(const Node& node, const std::vector<SystemRow>& rows, const EntryWriter& entries)
{
  Json::Value json;
  putCommon(json, node);
  json["stroke"] = entries.lines(std::get<Lines>(node.step->inputs.at(stroke1)));
  for (const auto& [member, property] : members1)
  {
    const Parameter* parameter = findParameter(*findSystem(system1, rows), property);
    json[member] = jsonOf(*parameter, valueOf(*node.step, *parameter));
  }
  return json;
}

Node nodeOf1(const JsonReader& json, const std::vector<SystemRow>& rows, EntryReader& entries)
{
  const SystemRow* row = findSystem(system1, rows);
  if (!row)
  {
    throw Failed(json.where() + ": is a step of " + system1 + ", which this version does not have");
  }
  auto step = std::make_shared<Step>();
  step->system = system1;
  step->inputs[stroke1] = entries.lines(json.text("stroke"));
  for (const auto& [member, property] : members1)
  {
    setValue(*step, json, member, *findParameter(*row, property));
  }
  Node node = commonOf(json, *step);
  node.step = step;
  return node;
}

Json::Value jsonOf2(const Node& node, const std::vector<SystemRow>& rows, const EntryWriter& entries)
{
  const Step& step = *node.step;
  Json::Value json;
  putCommon(json, node);
  json["id"] = node.id;
  json["system"] = step.system;
  json["values"] = Json::objectValue;
  json["inputs"] = Json::objectValue;
  if (const SystemRow* row = findSystem(step.system, rows))
  {
    for (const Parameter& parameter : row->parameters)
    {
      const Value& value = valueOf(step, parameter);
      if (!parameter.isLater || value != parameter.initial)
      {
        json["values"][parameter.property] = jsonOf(parameter, value);
      }
    }
  }
  if (step.part)
  {
    json["part"]["box"] = jsonList(step.part->box);
    json["part"]["depth"] = step.part->depth;
  }
  for (const auto& [name, input] : step.inputs)
  {
    json["inputs"][name] = jsonOfInput(input, entries);
  }
  return json;
}

Node nodeOf2(const JsonReader& json, const std::vector<SystemRow>& rows, EntryReader& entries)
{
  auto step = std::make_shared<Step>();
  step->system = json.text("system");
  const SystemRow* row = findSystem(step->system, rows);
  if (!row)
  {
    json.refuse("system", "is '" + step->system + "', which this version does not have");
  }
  const JsonReader values = json.object("values"), inputs = json.object("inputs");
  for (const std::string& name : values.names())
  {
    const Parameter* parameter = findParameter(*row, name);
    if (!parameter)
    {
      values.refuse(name, "is no parameter of " + row->name + " in this version");
    }
    setValue(*step, values, name, *parameter);
  }
  for (const std::string& name : inputs.names())
  {
    const SystemInput* input = findInput(*row, name);
    if (!input)
    {
      inputs.refuse(name, "is no input of " + row->name + " in this version");
    }
    step->inputs[name] = inputOf(inputs.object(name), input->kind, entries);
  }
  for (const SystemInput& input : row->inputs)
  {
    if (isNeeded(input, step->values) && input.kind != SystemInput::Kind::Mesh)
    {
      inputs.get(input.name);
    }
  }
  if (json.has("part"))
  {
    step->part = partOf(json);
  }
  Node node = commonOf(json, *step);
  node.id = json.integer("id", 1, largestId);
  node.step = step;
  return node;
}

Json::Value jsonOf(const Picture& picture, const EntryWriter& entries)
{
  Json::Value json = jsonOfInput(picture.image, entries);
  json["frame"] = entries.lines(picture.frame);
  json["opacity"] = picture.opacity;
  json["shown"] = picture.shown;
  if (picture.locked)
  {
    json["locked"] = true;
  }
  return json;
}

Picture pictureOf(const JsonReader& json, EntryReader& entries)
{
  Picture picture;
  picture.image = imageOf(json, entries);
  picture.frame = entries.lines(json.text("frame"));
  picture.opacity = json.number("opacity");
  picture.shown = json.yes("shown");
  picture.locked = json.has("locked") && json.yes("locked");
  if (!(picture.opacity >= 0.0 && picture.opacity <= 1.0))
  {
    json.refuse("opacity", "is not between 0 and 1");
  }
  try
  {
    const vtkSmartPointer<vtkPolyData> frame = picture.frame.own();
    oversketch::ViewOf(frame);
    if (oversketch::StrokeOf(frame).size() != 2)
    {
      json.refuse("frame", "has not two corners");
    }
  }
  catch (const oversketch::Error&)
  {
    json.refuse("frame", "is no stroke with its view");
  }
  return picture;
}

Json::Value jsonOf(const PartSource& part)
{
  Json::Value json;
  json["step"] = part.step;
  json["part"] = part.part;
  return json;
}

PartSource partSourceOf(const JsonReader& json)
{
  return { json.integer("step", 0, largestId), json.integer("part", 0, largest) };
}

Json::Value jsonOf(const Look& look)
{
  Json::Value json;
  json["position"] = jsonList(look.position);
  json["focus"] = jsonList(look.focus);
  json["up"] = jsonList(look.up);
  json["angle"] = look.angle;
  json["height"] = look.height;
  json["parallel"] = look.parallel;
  json["shift"] = jsonList(look.shift);
  if (look.size)
  {
    json["size"] = jsonList(*look.size);
  }
  if (look.upAxis != 1)
  {
    json["up_axis"] = look.upAxis;
  }
  return json;
}

Look lookOf(const JsonReader& json)
{
  const std::vector<double> shift = json.numbers("shift");
  if (shift.size() != 2)
  {
    json.refuse("shift", "is not two numbers");
  }
  const Look look{ json.point("position"),
    json.point("focus"),
    json.point("up"),
    json.number("angle"),
    json.number("height"),
    json.yes("parallel"),
    { shift[0], shift[1] },
    viewSizeOf(json),
    upAxisOf(json) };
  double along[3], across[3];
  vtkMath::Subtract(look.focus.data(), look.position.data(), along);
  vtkMath::Cross(along, look.up.data(), across);
  if (!(vtkMath::Norm(across) > 1e-9 * vtkMath::Norm(along) * vtkMath::Norm(look.up.data())) ||
      !std::isfinite(vtkMath::Norm(across)))
  {
    json.refuse("up", "is not across the line of sight");
  }
  if (!(look.angle > 0.0 && look.angle < 180.0))
  {
    json.refuse("angle", "is not between 0 and 180 degrees");
  }
  if (!(look.height > 0.0))
  {
    json.refuse("height", "is not above 0");
  }
  return look;
}

} // namespace oversketch_session
