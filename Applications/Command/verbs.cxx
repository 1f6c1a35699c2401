#include "verbs.h"

#include "files.h"
#include "heights.h"
#include "terminal.h"
#include "texture.h"
#include "upright_picture.h"

#include <filesystem>
#include <memory>

namespace oversketch_command
{

using namespace oversketch_files;
using namespace oversketch_session;

Image readImage(const std::string& path, SystemInput::Kind kind)
{
  requireReadable(path);
  Image image{ std::filesystem::path(path).filename().string(),
    std::make_shared<const std::string>(wholeFile(path)) };
  if (kind == SystemInput::Kind::Heights)
  {
    parseHeights(path, *image.bytes);
    return image;
  }
  image.bytes = std::make_shared<const std::string>(uprightPicture(*image.bytes));
  if (!pictureOf(*image.bytes))
  {
    throw Failed(path + ": is " + notAnUprightPicture);
  }
  return image;
}

std::vector<NamedFile> writtenBy(const Options& options)
{
  std::vector<NamedFile> written;
  for (const NamedFile& file : { NamedFile("-o", options.output),
         NamedFile("--report", options.report),
         NamedFile("--picture", options.picture) })
  {
    if (!file.second.empty())
    {
      written.push_back(file);
    }
  }
  return written;
}

void requireApart(std::vector<NamedFile> read, const std::vector<NamedFile>& written)
{
  for (const NamedFile& file : written)
  {
    for (const auto& [other, its] : read)
    {
      if (isSameFile(file.second, its) && !(file.first == "-o" && other == "the mesh"))
      {
        throw BadUse(file.first + " " + file.second + " would replace " + other);
      }
    }
    read.push_back(file);
  }
}

std::vector<Outcome> outcomesOf(Evaluator& evaluator, const Session& session, double done, double all)
{
  const auto count = static_cast<double>(session.nodes.size());
  Evaluator::Watch watch;
  watch.cancelled = interrupted;
  watch.progress = [=](std::size_t node, const std::string& stage, double share)
  { showProgress((done + (static_cast<double>(node) + share) / count) / all, stage); };
  std::vector<Outcome> outcomes;
  evaluator.run(session, watch, outcomes);
  clearProgress();
  throwIfInterrupted();
  return outcomes;
}

} // namespace oversketch_command
