// How a model was looked at: kept with the session, of no consequence to anything else; and what is saved.
#include "sessions.h"

#include "files.h"
#include "history.h"
#include "session_file.h"

#include <gtest/gtest.h>

#include <string>

using namespace oversketch_session;
using namespace oversketch_test;

namespace
{

Look fromTheSide()
{
  return { { 1.0 / 3.0, 2.0, -5.0 },
    { 0.0, 0.1, 0.0 },
    { 0.0, 1.0, 1e-3 },
    42.5,
    0.7,
    true,
    { 0.3, -1.0 / 7.0 },
    { { 640, 480 } },
    2 };
}

// session.json with one text in place of another.
Package withText(Package package, const std::string& from, const std::string& to)
{
  std::string text = *package.at(sessionEntry);
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  package[sessionEntry] = std::make_shared<std::string>(text.replace(at, from.size(), to));
  return package;
}

} // namespace

TEST(Look, IsKeptWithTheSessionAndIsNoPartOfIt)
{
  SessionFile file;
  file.session = dogSession();
  const Package without = Encoder().encode(file);
  EXPECT_EQ(without.at(sessionEntry)->find("\"look\""), std::string::npos) << "a member for nothing";
  EXPECT_FALSE(decode(without, "a").look);
  file.look = fromTheSide();
  const Package with = Encoder().encode(file);
  const SessionFile read = decode(with, "a");
  ASSERT_TRUE(read.look);
  EXPECT_TRUE(*read.look == *file.look) << "to the bit";
  // The version stays; an older program ignores the member, as it would this one.
  EXPECT_NE(with.at(sessionEntry)->find("\"format_version\" : 1"), std::string::npos);
  EXPECT_NO_THROW(decode(withText(with, "\"look\"", "\"later\""), "a"));
  SessionFile again = read;
  again.look.reset();
  EXPECT_EQ(*Encoder().encode(again).at(sessionEntry), *without.at(sessionEntry));
}

TEST(Look, FromWhichNothingIsSeenIsRefused)
{
  SessionFile file;
  file.session = dogSession();
  file.look = fromTheSide();
  const auto refuses = [](const SessionFile& bad)
  {
    try
    {
      decode(Encoder().encode(bad), "a");
    }
    catch (const oversketch_files::Failed& failed)
    {
      return std::string(failed.what()).find("look") != std::string::npos;
    }
    return false;
  };
  EXPECT_FALSE(refuses(file));
  const auto change = [&](const auto& how)
  {
    SessionFile bad = file;
    how(*bad.look);
    return refuses(bad);
  };
  EXPECT_TRUE(change([](Look& look) { look.focus = look.position; }));
  EXPECT_TRUE(change([](Look& look) { look.up = { 0.0, 0.0, 0.0 }; }));
  EXPECT_TRUE(change([](Look& look) { look.angle = 180.0; }));
  EXPECT_TRUE(change([](Look& look) { look.height = 0.0; }));
  file.look = fromTheSide();
  EXPECT_THROW(
    decode(withText(Encoder().encode(file), "\"shift\" : \n", "\"shift\" : [], \"other\" :\n"), "a"),
    oversketch_files::Failed)
    << "a look without a shift";
  EXPECT_TRUE(change([](Look& look) { look.size = { 640, 0 }; }));
  EXPECT_TRUE(change([](Look& look) { look.size = { 1 << 20, 480 }; }));
  file.look->size.reset();
  const auto old = decode(Encoder().encode(file), "a");
  EXPECT_TRUE(*old.look == *file.look) << "as it was written before sizes were kept";
}

TEST(History, KnowsWhatIsSaved)
{
  Session session = dogSession();
  History history(session);
  EXPECT_FALSE(history.isSaved()) << "nobody said so";
  history.markSaved();
  const auto next = [&]
  {
    session.backend = (session.backend + 1) % 3;
    return session;
  };
  history.commit(next());
  EXPECT_FALSE(history.isSaved());
  history.undo();
  EXPECT_TRUE(history.isSaved());
  history.redo();
  history.markSaved();
  history.amend(session);
  EXPECT_TRUE(history.isSaved()) << "what was learned is no change";
  history.mergeIntoLast(next());
  EXPECT_FALSE(history.isSaved());
  history.markSaved();
  history.undo();
  history.commit(next());
  EXPECT_FALSE(history.isSaved());
  history.undo();
  EXPECT_FALSE(history.isSaved()) << "what was saved cannot come back";
}
