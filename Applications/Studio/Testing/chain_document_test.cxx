// Drawings through all four systems as the window keeps them: its mesh is the evaluator's, of which
// chain_test shows that nothing tears, while steps are changed, undone, saved; of a change only what depends
// on it runs.
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

// One that keeps what it made: chain_test compares such ones with fresh ones.
std::string digestBy(Evaluator& evaluator, const Session& session)
{
  std::vector<Outcome> outcomes;
  EXPECT_TRUE(evaluator.run(session, {}, outcomes));
  return digestOf(resultOf(session, outcomes));
}

// Of the document's mesh, once all is computed; each step has done its part.
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

class ChainDocument : public testing::TestWithParam<DrawnChain>
{
};

} // namespace

TEST_P(ChainDocument, IsTheEvaluatorsMesh)
{
  const DrawnChain& chain = GetParam();
  Session session = drawingSession(chain);
  Evaluator evaluator;
  std::vector<Outcome> outcomes;
  ASSERT_TRUE(evaluator.run(session, {}, outcomes));
  const vtkSmartPointer<vtkPolyData> inflated = outcomes[0].mesh;
  session = chainSession(chain, inflated);
  const std::string first = digestBy(evaluator, session);
  const QTemporaryDir folder;
  const QString opened = folder.filePath("chain.oversketch"), saved = folder.filePath("saved.oversketch");
  writeSession(opened.toStdString(), { session, originHere(session.backend), first });

  Document document;
  std::set<int> ran;
  QObject::connect(
    &document, &Document::progressed, [&ran](int node, const QString&, double) { ran.insert(node); });
  document.open(Document::read(opened, 0));
  EXPECT_EQ(shownBy(document), first);
  EXPECT_EQ(ran, (std::set<int>{ 0, 1, 2, 3 }));

  std::vector<std::string> made{ first };
  const auto redraw = [&](int node, const auto& how)
  {
    change(session.nodes[static_cast<std::size_t>(node)], how);
    ran.clear();
    document.redraw(node, *session.nodes[static_cast<std::size_t>(node)].step);
    made.push_back(shownBy(document));
    EXPECT_EQ(made.back(), digestBy(evaluator, session)) << node;
    std::set<int> depends;
    for (int i = node; i < 4; ++i)
    {
      depends.insert(i);
    }
    EXPECT_EQ(ran, depends);
  };
  const View view = oversketch::ViewOfStroke(linesOf(*session.nodes[0].step, "Strokes"), 0);
  redraw(0,
    [&](Step& step) { step.inputs["Strokes"] = Lines(withOtherOutline(linesOf(step, "Strokes"), chain)); });
  redraw(1,
    [&](Step& step) { step.inputs["Stroke"] = Lines(toStroke(limbLine(inflated, view, chain, 1.3), view)); });
  redraw(2, [&](Step& step) { step.inputs["Profile"] = Lines(profileLine(1.2 * chain.rise)); });
  EXPECT_EQ(std::set<std::string>(made.begin(), made.end()).size(), 4u);

  document.save(saved);
  EXPECT_EQ(readSession(saved.toStdString()).digest, made.back());
  EXPECT_EQ(digestBy(evaluator, readSession(saved.toStdString()).session), made.back());
  // All undone and all redone: nothing runs again.
  ran.clear();
  for (int i = 2; i >= 0; --i)
  {
    document.undo();
    EXPECT_EQ(shownBy(document), made[static_cast<std::size_t>(i)]);
  }
  for (std::size_t i = 1; i < made.size(); ++i)
  {
    document.redo();
    EXPECT_EQ(shownBy(document), made[i]);
  }
  EXPECT_EQ(ran, std::set<int>());
  document.discardAutosave();
}

INSTANTIATE_TEST_SUITE_P(Drawings,
  ChainDocument,
  testing::ValuesIn(drawnChains()),
  [](const auto& which) { return std::string(which.param.name); });
