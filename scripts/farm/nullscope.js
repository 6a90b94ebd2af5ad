// A job type of Flamenco 3: the lines of `nullscope frames SCENE ... --commands`, a task for each. Goes into the folder
// scripts/ beside the Manager's program. docs/farm.md says how to submit a job.
const JOB_TYPE = {
    label: "nullscope frames",
    description: "Draw a sequence in chunks",
    settings: [
        { key: "lines", type: "string", required: true,
          description: "What nullscope frames ... --commands prints" },
        { key: "folder", type: "string", required: true,
          description: "The folder in which the lines run; all Workers must see it" },
    ],
};

function compileJob(job) {
    const lines = job.settings.lines.split("\n").filter(line => line.trim() !== "");
    lines.forEach((line, number) => {
        const task = author.Task(`chunk-${number + 1}`, "misc");
        task.addCommand(author.Command("exec", {
            exe: "/bin/sh",
            args: ["-c", 'cd "$1" && eval "exec $2"', "sh", job.settings.folder, line],
        }));
        job.addTask(task);
    });
}
