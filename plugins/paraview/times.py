# SPDX-License-Identifier: AGPL-3.0-or-later
# Reports the times of the steps to ParaView, which defines `self`, FileName and TimeSteps.
import json, os, subprocess

def wend(*arguments):
    try:
        done = subprocess.run([os.environ.get("WEND", "wend"), *arguments], capture_output=True, text=True)
    except OSError:
        raise RuntimeError("The program wend was not found. Please install Wend.")
    if done.returncode:
        raise RuntimeError(done.stderr.strip())
    return done.stdout

end = float(json.loads(wend("info", "--json", FileName))["end"])
executive, info = self.GetExecutive(), self.GetExecutive().GetOutputInformation(0)
info.Remove(executive.TIME_STEPS())
info.Remove(executive.TIME_RANGE())
for k in range(TimeSteps):
    info.Append(executive.TIME_STEPS(), end * k / (TimeSteps - 1))
for time in (0.0, end):
    info.Append(executive.TIME_RANGE(), time)
