// Several models in one scene: as values, in the file, in the history.
#include "sessions.h"

#include "history.h"
#include "models.h"
#include "session_file.h"

#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <string>

using namespace oversketch_session;
using namespace oversketch_test;

namespace
{

Session pairOf()
{
  const Session dog = dogSession();
  return withModels(dog, modelsOf(dog));
}

std::string textOf(const Package& package)
{
  return *package.at(sessionEntry);
}

} // namespace

TEST(Models, OneIsChosenAndTheOthersKeepTheirPlaces)
{
  const Session pair = pairOf();
  ASSERT_EQ(modelCount(pair), 2u);
  EXPECT_EQ(restingAt(pair, 0), nullptr);
  const RestingModel* second = restingAt(pair, 1);
  ASSERT_TRUE(second);
  ASSERT_TRUE(second->made.mesh);
  EXPECT_EQ(second->made.digest, digestOf(second->made.mesh));
  EXPECT_NE(second->own.id, pair.id);
  const Session other = withChosen(pair, 1, second->made);
  EXPECT_EQ(other.place, 1u);
  EXPECT_EQ(modelAt(other, 0).id, pair.id);
  EXPECT_EQ(modelAt(other, 1).id, second->own.id);
  const Session alone = withoutModel(other, 0);
  EXPECT_EQ(modelCount(alone), 1u);
  EXPECT_EQ(alone.place, 0u);
  const Session seen = withModelSeen(withModelSeen(pair, 0, true, true), 1, false, false);
  EXPECT_TRUE(seen.locked);
  EXPECT_FALSE(modelAt(seen, 1).shown);
  EXPECT_TRUE(modelAt(pair, 1).shown) << "a value was changed";
}

TEST(Models, AreInTheFileWhereThereAreAny)
{
  SessionFile file;
  file.session = dogSession();
  const std::string single = textOf(Encoder().encode(file));
  EXPECT_NE(single.find("\"format_version\" : 1"), std::string::npos);
  for (const char* member : { "\"models\"", "\"place\"", "\"shown\"", "\"locked\"" })
  {
    EXPECT_EQ(single.find(member), std::string::npos) << member;
  }
  const Session pair = withModelSeen(pairOf(), 0, false, true);
  file.session = withChosen(pair, 1, restingAt(pair, 1)->made);
  file.others = { { originHere(0), "0123" } };
  const Package package = Encoder().encode(file);
  EXPECT_NE(textOf(package).find("\"format_version\" : 2"), std::string::npos);
  SessionFile read = decode(package, "a");
  ASSERT_EQ(modelCount(read.session), 2u);
  EXPECT_EQ(read.session.place, 1u);
  const Model& rests = modelAt(read.session, 0);
  EXPECT_FALSE(rests.shown);
  EXPECT_TRUE(rests.locked);
  EXPECT_TRUE(read.session.shown);
  EXPECT_EQ(rests.nodes.size(), pair.nodes.size());
  ASSERT_EQ(read.others.size(), 1u);
  EXPECT_EQ(read.others[0].digest, "0123");
  EXPECT_FALSE(restingAt(read.session, 0)->made.mesh) << "no result is kept";
  EXPECT_EQ(textOf(Encoder().encode(read)), textOf(package));
  makeResting(read.session);
  EXPECT_EQ(restingAt(read.session, 0)->made.digest, restingAt(pair, 1)->made.digest) << "the same steps";
}

TEST(Models, AreUndoneWithTheSteps)
{
  const Session pair = pairOf();
  History history(dogSession());
  history.commit(pair);
  history.amend(withChosen(pair, 1, restingAt(pair, 1)->made));
  EXPECT_EQ(history.now().place, 1u);
  history.undo();
  EXPECT_EQ(modelCount(history.now()), 1u);
  EXPECT_EQ(history.now().nodes.size(), pair.nodes.size());
  history.redo();
  EXPECT_EQ(modelCount(history.now()), 2u);
  EXPECT_EQ(history.now().place, 1u) << "as it was chosen last";
}

TEST(Models, LargeOnesAreWorkedOnByProxiesAndKeptWhole)
{
  Session session = dogSession();
  const std::string digest = digestOf(session.mesh);
  const vtkIdType all = session.mesh->GetNumberOfPolys();
  makeProxies(session, all, {});
  EXPECT_FALSE(session.whole) << "it is not larger";
  Session drawn = session;
  drawn.nodes[0] = changed(drawn.nodes[0], [](Step& step) { step.system = "Terrain"; });
  makeProxies(drawn, all - 1, {});
  EXPECT_FALSE(drawn.whole) << "a step of it is none that acts on proxies";

  session.others = modelsOf(dogSession());
  makeProxies(session, all - 1, {});
  for (std::size_t place = 0; place < 2; ++place)
  {
    const Model& model = modelAt(session, place);
    ASSERT_TRUE(model.whole);
    EXPECT_EQ(digestOf(model.whole), digest);
    EXPECT_LT(model.mesh->GetNumberOfPolys(), all / 8);
    EXPECT_TRUE(model.mesh->GetPointData()->GetArray("Origin"));
  }
  SessionFile file;
  file.session = session;
  file.others.resize(1);
  Session read = decode(Encoder().encode(file), "a").session;
  EXPECT_EQ(digestOf(read.mesh), digest);
  EXPECT_EQ(digestOf(modelAt(read, 1).mesh), digest);
  makeProxies(read, all - 1, {});
  EXPECT_EQ(digestOf(read.mesh), digestOf(session.mesh));
  EXPECT_EQ(digestOf(exactOf(read.whole, read.mesh)), digest) << "no step has moved it";
}
