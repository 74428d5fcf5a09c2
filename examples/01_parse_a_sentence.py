"""What the robot understands of a sentence: tasks, arguments and control flow.

Output:

    [2] change_state: close the window
    [1] bringing: bring me the cup
    bringing (1.0)
      recipient: me
      object: the cup
    change_state (1.0)
      object: the window
    [2, 1]
"""

import decomplex_bt

interpreter = decomplex_bt.Interpreter.load("household")
instruction = interpreter.interpret("Before you bring me the cup, close the window.")

print(instruction)  # the control flow: the window comes first
for task in instruction.tasks:
    print(f"{task.type} ({task.confidence:.1f})")
    for argument in task.arguments:
        print(f"  {argument.type}: {argument.value}")
print(instruction.flow.to_json())
