rocinante spy nonsense
