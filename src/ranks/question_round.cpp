#include "ranks/question_round.h"

#include <utility>

namespace cellsweep::ranks {
namespace {

template <class Row>
Message message_of(int rank, std::span<const Row> rows) {
  MessageWriter writer;
  writer.write(rows);
  return {rank, writer.take()};
}

}  // namespace

Status ask_ranks(const Job& job, std::span<const std::vector<QuestionRow>> to, Answerer answerer,
                 std::vector<AnswerRow>& answers) {
  std::vector<Message> asked;
  std::vector<Message> got;
  Status status = job.agree([&]() -> Status {
    for (std::size_t rank = 0; rank < to.size(); ++rank) {
      if (!to[rank].empty() && static_cast<int>(rank) != job.rank())
        asked.push_back(message_of<QuestionRow>(static_cast<int>(rank), to[rank]));
    }
    return {};
  });
  if (!status.ok()) return status;
  Status questions_came = job.exchange(asked, got);
  std::vector<Message> answered;
  status = job.agree([&]() -> Status {
    if (!questions_came.ok()) return questions_came;
    for (const Message& message : got) {
      const auto questions = MessageReader(message.words).read<QuestionRow>();
      std::vector<AnswerRow> rows;
      if (Status failed = answerer(questions, rows); !failed.ok()) return failed;
      answered.push_back(message_of<AnswerRow>(message.rank, rows));
    }
    return answerer(to[static_cast<std::size_t>(job.rank())], answers);
  });
  if (!status.ok()) return status;
  Status answers_came = job.exchange(answered, got);
  return job.agree([&]() -> Status {
    if (!answers_came.ok()) return answers_came;
    for (const Message& message : got) {
      const auto rows = MessageReader(message.words).read<AnswerRow>();
      answers.insert(answers.end(), rows.begin(), rows.end());
    }
    return {};
  });
}

}  // namespace cellsweep::ranks
