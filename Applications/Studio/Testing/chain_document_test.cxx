// A drawing through all four systems as the window keeps it: its mesh is the evaluator's, while steps are
// changed, undone, saved.
#include "Chain/drawn_chain.h"

#include "document.h"
#include "session_file.h"

#include <QTemporaryDir>
#include <QTest>

using namespace oversketch_session;
using namespace oversketch_test;
using oversketch_studio::Document;

namespace
{

std::string digestBy(const Session& session)
{
  Evaluator evaluator;
  std::vector<Outcome> outcomes;
  EXPECT_TRUE(evaluator.run(session, {}, outcomes));
  return digestOf(resultOf(session, outcomes));
}

// Of the document's mesh, once all is computed.
std::string shownBy(const Document& document)
{
  EXPECT_TRUE(QTest::qWaitFor([&] { return document.isSettled(); }, 600000));
  for (const Worker::NodeState& node : document.result().nodes)
  {
    EXPECT_EQ(node.failure, "");
    EXPECT_FALSE(node.elsewhere);
  }
  EXPECT_EQ(document.digest(), digestOf(document.result().mesh));
  return document.digest();
}

} // namespace

TEST(ChainDocument, IsTheEvaluatorsMesh)
{
  const DrawnChain& chain = drawnChains().front();
  Session session = drawingSession(chain);
  Evaluator evaluator;
  std::vector<Outcome> outcomes;
  ASSERT_TRUE(evaluator.run(session, {}, outcomes));
  session = chainSession(chain, outcomes[0].mesh);
  const std::string first = digestBy(session);
  const QTemporaryDir folder;
  const QString opened = folder.filePath("chain.oversketch"), saved = folder.filePath("saved.oversketch");
  writeSession(opened.toStdString(), { session, originHere(session.backend), first });

  Document document;
  document.open(Document::read(opened, 0));
  EXPECT_EQ(shownBy(document), first);

  const auto redraw = [&](int node, const auto& how)
  {
    change(session.nodes[static_cast<std::size_t>(node)], how);
    document.redraw(node, *session.nodes[static_cast<std::size_t>(node)].step);
    const std::string digest = shownBy(document);
    EXPECT_EQ(digest, digestBy(session)) << node;
    return digest;
  };
  const std::string outline = redraw(0,
    [&](Step& step) { step.inputs["Strokes"] = Lines(withOtherOutline(linesOf(step, "Strokes"), chain)); });
  const std::string profile =
    redraw(2, [&](Step& step) { step.inputs["Profile"] = Lines(profileLine(1.2 * chain.rise)); });
  EXPECT_EQ((std::set<std::string>{ first, outline, profile }.size()), 3u);
  document.save(saved);
  EXPECT_EQ(readSession(saved.toStdString()).digest, profile);
  EXPECT_EQ(digestBy(readSession(saved.toStdString()).session), profile);
  document.undo();
  EXPECT_EQ(shownBy(document), outline);
  document.undo();
  EXPECT_EQ(shownBy(document), first);
  document.redo();
  EXPECT_EQ(shownBy(document), outline);
  document.discardAutosave();
}
