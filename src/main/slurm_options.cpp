#include "main/slurm_options.h"

#include "base/error.h"

namespace fissure {

void addSlurmOptions(Command command, SlurmOptions& options) {
  command
      .option("--engine", options.engine,
              "local: simulate here; slurm: submit what is missing to this Slurm cluster")
      .oneOf({"local", "slurm"})
      .showDefault();
  command
      .option("--shards", options.shards,
              "slurm: tasks of the array; default: so many that each takes --shard-minutes, or as before")
      .between(1, 10000000);
  command.option("--shard-minutes", options.shard_minutes, "slurm: how long a shard should take; default: 20")
      .between(0.01, 1e6);
  command.flag("--no-submit", options.no_submit, "slurm: write the sbatch files, and submit nothing");
  command.flag("--again", options.again, "slurm: submit although jobs of this sweep are queued");
  command.option("sbatch", options.sbatch, "slurm: after --, options of sbatch, for both jobs")
      .called("-- OPTIONS");
}

void refuseSlurmOptions(const SlurmOptions& options) {
  const auto refuse = [](bool given, const std::string& what) {
    if (given) throw InputError("sweep: " + what + " was not expected without --engine slurm");
  };
  refuse(options.shards.has_value(), "--shards");
  refuse(options.shard_minutes.has_value(), "--shard-minutes");
  refuse(options.no_submit, "--no-submit");
  refuse(options.again, "--again");
  refuse(!options.sbatch.empty(), options.sbatch.empty() ? "" : options.sbatch.front());
}

}  // namespace fissure
